#include "tank_datum/io/scan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "io/scan_source.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

/// The first finite point in whole metres, however many others come before it; zero if there is none.
Eigen::Vector3d findOrigin(const std::vector<std::shared_ptr<const Scan::Source>>& sources) {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  bool found = false;
  for (const auto& source : sources) {
    if (found) break;
    source->visit(Eigen::Vector3d::Zero(), [&](const Points& block, const Labels&) {
      origin = block.front().array() + 0.0;  // + 0.0: no negative zero in the outputs
      found = true;
      return false;
    });
  }
  return origin;
}

}  // namespace

Scan Scan::open(const std::vector<std::string>& paths, double metres_per_unit) {
  if (paths.empty()) throw Error(Error::Kind::Option, "io", "scans", "none", "at least one file");
  if (!(metres_per_unit > 0.0 && std::isfinite(metres_per_unit))) {
    throw Error(Error::Kind::Option, "io", "metres_per_unit", std::to_string(metres_per_unit), "a number > 0");
  }
  Scan scan;
  scan.paths_ = paths;
  for (const std::string& path : paths) scan.sources_.push_back(pcdSource(path, metres_per_unit));
  scan.origin_ = findOrigin(scan.sources_);
  return scan;
}

Scan Scan::fromPoints(const Points& points) {
  const auto kept = std::make_shared<const Points>(points);
  return fromRows(kept->size(), [kept](std::uint64_t i) { return (*kept)[i]; });
}

Scan Scan::fromRows(std::uint64_t rows, Row row) {
  Scan scan;
  scan.sources_.push_back(arraySource(rows, std::move(row)));
  scan.origin_ = findOrigin(scan.sources_);
  return scan;
}

ScanCounts Scan::forEachBlock(const Visitor& visit) const {
  ScanCounts total;
  for (const auto& source : sources_) {
    total += source->visit(origin_, [&](const Points& block, const Labels&) {
      visit(block);
      return true;
    });
  }
  return total;
}

double Scan::coordinateStep() const {
  double step = 0.0;
  for (const auto& source : sources_) step = std::max(step, source->coordinateStep(origin_));
  return step;
}

ScanCounts Scan::forEachChosen(const Chooser& choose, int threads, const Visitor& visit, std::uint64_t n) const {
  return forEachChosen(
      choose, threads, [&visit](const Points& chosen, SetupKey) { visit(chosen); }, n);
}

ScanCounts Scan::forEachChosen(const Chooser& choose, int threads, const SetupVisitor& visit, std::uint64_t n) const {
  if (n < 1) throw Error(Error::Kind::Option, "io", "n of the rows looked at", "0", "at least 1");
  ScanCounts total;
  std::uint64_t block = 0;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto told = [&](const ScanCounts& read, const Points& chosen, std::uint32_t label) {
      total += read;
      if (!chosen.empty()) visit(chosen, {static_cast<std::uint32_t>(i), label});
      if (progress_) progress_(total.points);
    };
    sources_[i]->choose(origin_, {choose, n}, threads, block, told);
  }
  return total;
}

bool Scan::tellsSetups() const {
  return sources_.size() > 1 || (sources_.size() == 1 && !sources_.front()->labelField().empty());
}

std::string Scan::setupName(SetupKey setup) const {
  const std::string field = sources_[setup.source]->labelField();
  const std::string label = setup.label == SetupKey::kUnlabelled ? "none" : std::to_string(setup.label);
  const bool has_file = setup.source < paths_.size();
  const std::string file = has_file ? std::filesystem::path(paths_[setup.source]).stem().string() : "scan";
  if (field.empty()) return file;
  return sources_.size() > 1 ? file + ":" + label : label;
}

std::optional<Eigen::Vector3d> Scan::setupOrigin(SetupKey setup) const {
  if (!sources_[setup.source]->labelField().empty()) return std::nullopt;
  std::optional<Eigen::Vector3d> place = sources_[setup.source]->viewpoint();
  if (place) *place -= origin_;
  return place;
}

Points Scan::everyNth(std::uint64_t n, int threads) const {
  Points all;
  all.reserve(std::min<std::uint64_t>(size() / std::max<std::uint64_t>(1, n) + 1,
                                      4'000'000));  // a header may promise more than there is
  const auto choose = [](std::uint64_t, const Points& points, Points& chosen) { chosen = points; };
  forEachChosen(
      choose, threads, [&all](const Points& chosen) { all.insert(all.end(), chosen.begin(), chosen.end()); }, n);
  return all;
}

std::uint64_t Scan::size() const {
  std::uint64_t rows = 0;
  for (const auto& source : sources_) rows += source->size();
  return rows;
}

}  // namespace tank_datum
