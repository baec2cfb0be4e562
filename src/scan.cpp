#include "tank_datum/scan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coordinates.h"
#include "input_file.h"
#include "pcd_data.h"
#include "tank_datum/error.h"
#include "tank_datum/parallel.h"
#include "tank_datum/pcd_header.h"

namespace tank_datum {

class Scan::Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t size() const = 0;
  virtual double coordinateStep(const Eigen::Vector3d& origin) const = 0;
  virtual ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const = 0;

  /// Told the rows read since the last call, and what was chosen of them.
  using ChosenVisitor = std::function<void(const ScanCounts& read, const Points& chosen)>;

  /// @param block  number of the source's first block; raised by the blocks read
  virtual void choose(const Eigen::Vector3d& origin, const Scan::Chooser& choose, int /*threads*/, std::uint64_t& block,
                      const ChosenVisitor& told) const {
    Points chosen;
    std::uint64_t kept = 0;
    const ScanCounts all = visit(origin, [&](const Points& points) {
      chosen.clear();
      choose(block++, points, chosen);
      kept += points.size();
      told({points.size(), 0}, chosen);
      return true;
    });
    told({all.points - kept, all.invalid}, {});
  }
};

namespace {

class PcdSource : public Scan::Source {
 public:
  PcdSource(const std::string& path, double metres_per_unit)
      : file_(path), header_(readPcdHeader(file_)), metres_per_unit_(metres_per_unit) {}

  std::uint64_t size() const override { return header_.points; }

  double coordinateStep(const Eigen::Vector3d& origin) const override {
    double step = 0.0;
    if (header_.encoding == PcdEncoding::Ascii) return step;  // text has the digits it was written with
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const PcdColumn& column = header_.columns[header_.xyz[static_cast<std::size_t>(axis)]];
      if (column.type != 'F') continue;
      const double stored = std::abs(origin[axis]) / metres_per_unit_;
      const double next = column.size == 4 ? static_cast<double>(std::nextafter(static_cast<float>(stored), HUGE_VALF))
                                           : std::nextafter(stored, HUGE_VAL);
      const double value = column.size == 4 ? static_cast<double>(static_cast<float>(stored)) : stored;
      step = std::max(step, (next - value) * metres_per_unit_);
    }
    return step;
  }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    return visitPcd(file_, header_, {metres_per_unit_, origin}, visit);
  }

  void choose(const Eigen::Vector3d& origin, const Scan::Chooser& choose, int threads, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    if (header_.encoding != PcdEncoding::Binary) return Source::choose(origin, choose, threads, block, told);
    constexpr std::uint64_t kRound = 64;  // blocks; a million rows between two calls of told
    const Frame frame{metres_per_unit_, origin};
    const std::uint64_t count = binaryBlockCount(header_);
    std::vector<Points> chosen(kRound);
    std::vector<ScanCounts> read(kRound);
    for (std::uint64_t begin = 0; begin < count; begin += kRound) {
      const auto blocks = static_cast<std::size_t>(std::min(kRound, count - begin));
      forEachIndex(blocks, threads, [&](std::size_t i) {
        thread_local BlockBuffer buffer;
        const std::size_t rows = decodeBinaryBlock(file_, header_, frame, begin + i, buffer);
        read[i] = {rows, rows - buffer.points.size()};
        chosen[i].clear();
        choose(block + begin + i, buffer.points, chosen[i]);
      });
      for (std::size_t i = 0; i < blocks; ++i) told(read[i], chosen[i]);
    }
    block += count;
  }

 private:
  InputFile file_;  // stays open: every pass sees the same file
  PcdHeader header_;
  double metres_per_unit_;
};

class ArraySource : public Scan::Source {
 public:
  ArraySource(std::uint64_t rows, Scan::Row row) : rows_(rows), row_(std::move(row)) {}

  std::uint64_t size() const override { return rows_; }

  double coordinateStep(const Eigen::Vector3d&) const override { return 0.0; }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    const Frame frame{1.0, origin};
    ScanCounts counts;
    Points block;
    while (counts.points < rows_) {
      const std::uint64_t end = std::min<std::uint64_t>(counts.points + kBlockRows, rows_);
      block.clear();
      for (std::uint64_t i = counts.points; i < end; ++i) appendFinite(row_(i), frame, block);
      counts.invalid += end - counts.points - block.size();
      counts.points = end;
      if (!block.empty() && !visit(block)) break;
    }
    return counts;
  }

 private:
  std::uint64_t rows_;
  Scan::Row row_;
};

/// The first finite point in whole metres, however many others come before it; zero if there is none.
Eigen::Vector3d findOrigin(const std::vector<std::shared_ptr<const Scan::Source>>& sources) {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  bool found = false;
  for (const auto& source : sources) {
    if (found) break;
    source->visit(Eigen::Vector3d::Zero(), [&](const Points& block) {
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
  for (const std::string& path : paths) scan.sources_.push_back(std::make_shared<PcdSource>(path, metres_per_unit));
  scan.origin_ = findOrigin(scan.sources_);
  return scan;
}

Scan Scan::fromPoints(const Points& points) {
  const auto kept = std::make_shared<const Points>(points);
  return fromRows(kept->size(), [kept](std::uint64_t i) { return (*kept)[i]; });
}

Scan Scan::fromRows(std::uint64_t rows, Row row) {
  Scan scan;
  scan.sources_.push_back(std::make_shared<ArraySource>(rows, std::move(row)));
  scan.origin_ = findOrigin(scan.sources_);
  return scan;
}

ScanCounts Scan::forEachBlock(const Visitor& visit) const {
  ScanCounts total;
  for (const auto& source : sources_) {
    const ScanCounts counts = source->visit(origin_, [&](const Points& block) {
      visit(block);
      return true;
    });
    total.points += counts.points;
    total.invalid += counts.invalid;
  }
  return total;
}

double Scan::coordinateStep() const {
  double step = 0.0;
  for (const auto& source : sources_) step = std::max(step, source->coordinateStep(origin_));
  return step;
}

ScanCounts Scan::forEachChosen(const Chooser& choose, int threads, const Visitor& visit) const {
  ScanCounts total;
  std::uint64_t block = 0;
  for (const auto& source : sources_) {
    source->choose(origin_, choose, threads, block, [&](const ScanCounts& read, const Points& chosen) {
      total.points += read.points;
      total.invalid += read.invalid;
      if (!chosen.empty()) visit(chosen);
      if (progress_) progress_(total.points);
    });
  }
  return total;
}

std::uint64_t Scan::size() const {
  std::uint64_t rows = 0;
  for (const auto& source : sources_) rows += source->size();
  return rows;
}

}  // namespace tank_datum
