#include "tank_datum/io/scan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/plain_text.h"
#include "io/input_file.h"
#include "io/scan_format.h"
#include "io/scan_origin.h"
#include "io/scan_source.h"
#include "io/setup_pick.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

void requireClasses(const std::vector<int>& classes) {
  for (const int code : classes) {
    if (code >= 0 && code <= 255) continue;
    throw Error(Error::Kind::Option, "io", "las_classes", std::to_string(code), "codes from 0 to 255");
  }
}

const Points& turnInto(Points& turned, const Points& points, const Eigen::Matrix3d& rotation) {
  turned.clear();
  for (const Eigen::Vector3d& p : points) turned.push_back(rotation * p);
  return turned;
}

}  // namespace

/// A file as the readers share it.
struct Scan::File {
  std::shared_ptr<const InputFile> input;

  /// A pass over it; of a file that changed meanwhile that is the reason, whatever the pass met.
  template <class Pass>
  static void passOver(const std::vector<std::shared_ptr<const File>>& files, std::size_t i, const Pass& pass) {
    const InputFile* file = i < files.size() ? files[i]->input.get() : nullptr;
    try {
      pass();
    } catch (const Error&) {
      if (file) file->requireUnchanged();
      throw;
    }
    if (file) file->requireUnchanged();
  }
};

const char* nameOf(Checksum checksum) {
  return checksum == Checksum::None ? "none" : checksum == Checksum::Xxh3 ? "xxh3" : "sha256";
}

Scan Scan::open(const std::vector<std::string>& paths, double metres_per_unit, const ScanOptions& options) {
  if (paths.empty()) throw Error(Error::Kind::Option, "io", "scans", "none", "at least one file");
  if (!(metres_per_unit > 0.0 && std::isfinite(metres_per_unit))) {
    throw Error(Error::Kind::Option, "io", "metres_per_unit", fixedText(metres_per_unit), "a number > 0");
  }
  requireClasses(options.las_classes);
  Scan scan;
  scan.paths_ = paths;
  for (const std::string& path : paths) {
    const auto input = std::make_shared<const InputFile>(path, options.hash);
    scan.files_.push_back(std::make_shared<const File>(File{input}));
    scan.sources_.push_back(openSource(input, metres_per_unit, options));
  }
  if (!options.setups.empty()) scan.pickSetups(options.setups);
  scan.origin_ = scan.stored_origin_ = findOrigin(scan.sources_);
  return scan;
}

void Scan::pickSetups(const std::vector<std::string>& names) {
  std::vector<std::string> missing = names;
  std::string there;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const std::vector<std::uint32_t> labels = labelsIn(*sources_[i]);
    std::vector<std::uint32_t> wanted;
    for (const std::uint32_t label : labels) {
      const std::string name = setupName({static_cast<std::uint32_t>(i), label});
      const std::string own = sources_[i]->labelField().empty() ? name : sources_[i]->labelName(label);
      const auto is_it = [&](const std::string& given) { return given == name || given == own; };
      if (std::any_of(names.begin(), names.end(), is_it)) wanted.push_back(label);
      missing.erase(std::remove_if(missing.begin(), missing.end(), is_it), missing.end());
      there += (there.empty() ? "" : ", ") + name;
    }
    if (wanted.size() < labels.size()) sources_[i] = pickedSource(sources_[i], wanted);
  }
  if (missing.empty()) return;
  throw Error(Error::Kind::Option, "io", "setups", missing.front(), "names of setups that the scan has: " + there);
}

Scan Scan::fromPoints(const Points& points) {
  const auto kept = std::make_shared<const Points>(points);
  return fromRows(kept->size(), [kept](std::uint64_t i) { return (*kept)[i]; });
}

Scan Scan::fromRows(std::uint64_t rows, Row row, RowNumbers numbers) {
  Scan scan;
  scan.sources_.push_back(arraySource(rows, std::move(row), numbers));
  scan.origin_ = scan.stored_origin_ = findOrigin(scan.sources_);
  return scan;
}

Scan Scan::fromBlocks(ScanBlocks blocks) {
  Scan scan;
  scan.sources_.push_back(streamSource(std::move(blocks)));
  scan.origin_ = scan.stored_origin_ = findOrigin(scan.sources_);
  return scan;
}

Scan Scan::turned(const Eigen::Matrix3d& rotation) const { return turnedAbout(Eigen::Vector3d::Zero(), rotation); }

Scan Scan::turnedAbout(const Eigen::Vector3d& point, const Eigen::Matrix3d& rotation) const {
  Scan scan = *this;
  scan.rotation_ = rotation_ ? Eigen::Matrix3d(rotation * *rotation_) : rotation;
  scan.origin_ = (point + rotation * (origin_ - point)).array() + 0.0;
  return scan;
}

Scan Scan::relativeTo(const Eigen::Vector3d& origin) const {
  Scan scan = *this;
  scan.stored_origin_ = origin;
  if (rotation_) scan.stored_origin_ = stored_origin_ + rotation_->transpose() * (origin - origin_);
  scan.origin_ = origin;
  return scan;
}

ScanCounts Scan::forEachBlock(const Visitor& visit) const {
  return forEachLabelled([&visit](const Points& block, std::uint32_t, const Labels&) { visit(block); });
}

ScanCounts Scan::forEachLabelled(const LabelledVisitor& visit) const {
  ScanCounts total;
  Points turned;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto told = [&](const Points& block, const Labels& labels) {
      visit(rotation_ ? turnInto(turned, block, *rotation_) : block, static_cast<std::uint32_t>(i), labels);
      return true;
    };
    File::passOver(files_, i, [&] { total += sources_[i]->visit(stored_origin_, told); });
  }
  return total;
}

double Scan::coordinateStep() const {
  double step = 0.0;
  for (const auto& source : sources_) step = std::max(step, source->coordinateStep(stored_origin_));
  return step;
}

ScanCounts Scan::forEachChosen(const Chooser& choose, int threads, const Visitor& visit, std::uint64_t n) const {
  return forEachChosen(
      choose, threads, [&visit](const Points& chosen, SetupKey) { visit(chosen); }, n);
}

ScanCounts Scan::forEachChosen(const Chooser& choose, int threads, const SetupVisitor& visit, std::uint64_t n) const {
  return this->choose(choose, threads, visit, n, false);
}

ScanCounts Scan::choose(const Chooser& choose, int threads, const SetupVisitor& visit, std::uint64_t n,
                        bool of_parts) const {
  if (n < 1) throw Error(Error::Kind::Option, "io", "n of the rows looked at", "0", "at least 1");
  const Chooser from_turned = [&](std::uint64_t at, const Points& points, Points& chosen) {
    thread_local Points turned;
    choose(at, turnInto(turned, points, *rotation_), chosen);
  };
  ScanCounts total;
  std::uint64_t block = 0;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto told = [&](const ScanCounts& read, const Points& chosen, std::uint32_t label) {
      total += read;
      if (!chosen.empty()) visit(chosen, {static_cast<std::uint32_t>(i), label});
      if (progress_) progress_(total.points);
    };
    File::passOver(files_, i, [&] {
      sources_[i]->choose(stored_origin_, {rotation_ ? from_turned : choose, n, of_parts}, threads, block, told);
    });
  }
  return total;
}

bool Scan::tellsSetups() const {
  return sources_.size() > 1 || (sources_.size() == 1 && !sources_.front()->labelField().empty());
}

std::vector<SetupKey> Scan::setups() const {
  std::vector<SetupKey> all;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    for (const std::uint32_t label : labelsIn(*sources_[i])) all.push_back({static_cast<std::uint32_t>(i), label});
  }
  return all;
}

std::string Scan::setupLabel(SetupKey setup) const {
  const Source& source = *sources_[setup.source];
  return source.labelField().empty() ? "" : source.labelName(setup.label);
}

std::string Scan::setupName(SetupKey setup) const {
  const std::string label = setupLabel(setup);
  const bool has_file = setup.source < paths_.size();
  const std::string file = has_file ? std::filesystem::path(paths_[setup.source]).stem().string() : "scan";
  if (label.empty()) return file;
  return sources_.size() > 1 ? file + ":" + label : label;
}

std::optional<Eigen::Vector3d> Scan::setupOrigin(SetupKey setup) const {
  std::optional<Eigen::Vector3d> place = sources_[setup.source]->viewpoint(setup.label);
  if (place) *place -= stored_origin_;
  if (place && rotation_) *place = *rotation_ * *place;
  return place;
}

Points Scan::everyNth(std::uint64_t n, int threads) const {
  Points all;
  all.reserve(std::min<std::uint64_t>(size() / std::max<std::uint64_t>(1, n) + 1,
                                      4'000'000));  // a header may promise more than there is
  const auto choose = [](std::uint64_t, const Points& points, Points& chosen) { chosen = points; };
  const auto keep = [&all](const Points& chosen, SetupKey) { all.insert(all.end(), chosen.begin(), chosen.end()); };
  this->choose(choose, threads, keep, n, true);
  return all;
}

std::uint64_t Scan::sizeOf(std::size_t file) const { return sources_.at(file)->size(); }

std::string Scan::hashOf(std::size_t file, const std::function<bool()>& wanted) const {
  return files_.at(file)->input->xxh3(wanted);
}

void Scan::requireUnchanged() const {
  for (const auto& file : files_) file->input->requireUnchanged();
}

std::uint64_t Scan::size() const {
  std::uint64_t rows = 0;
  for (const auto& source : sources_) rows += source->size();
  return rows;
}

}  // namespace tank_datum
