#include "io/scan_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "io/coordinates.h"
#include "io/input_file.h"
#include "io/pcd_header.h"

namespace tank_datum {
namespace {

/// What is chosen of a block, label by label.
struct ChosenOfLabel {
  std::uint32_t label = 0;
  Points points;
};

/// Asks the chooser for a block: once, or once for each of its labels in rising order.
void chooseByLabel(const Scan::Chooser& choose, std::uint64_t block, const Points& points, const Labels& labels,
                   std::vector<ChosenOfLabel>& chosen) {
  Labels found = labels;
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  chosen.resize(std::max<std::size_t>(1, found.size()));
  if (found.size() < 2) {
    chosen.front().label = found.empty() ? 0 : found.front();
    chosen.front().points.clear();
    choose(block, points, chosen.front().points);
    return;
  }
  Points alike;
  for (std::size_t k = 0; k < found.size(); ++k) {
    alike.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (labels[i] == found[k]) alike.push_back(points[i]);
    }
    chosen[k].label = found[k];
    chosen[k].points.clear();
    choose(block, alike, chosen[k].points);
  }
}

/// Tells what was chosen of one block, its counts with the first.
void tell(const Scan::Source::ChosenVisitor& told, const ScanCounts& read, const std::vector<ChosenOfLabel>& chosen) {
  for (std::size_t k = 0; k < chosen.size(); ++k) told(k == 0 ? read : ScanCounts{}, chosen[k].points, chosen[k].label);
}

/// Block by block, for what cannot be read from any place: only the choice is thinned.
void chooseInOrder(const Scan::Source& source, const Eigen::Vector3d& origin, const Scan::Source::Choice& choice,
                   std::uint64_t& block, const Scan::Source::ChosenVisitor& told) {
  Points thinned;
  Labels labels;
  std::vector<ChosenOfLabel> chosen;
  std::uint64_t finite = 0;
  const ScanCounts all = source.visit(origin, [&](const Points& points, const Labels& of_points) {
    thinned.clear();
    labels.clear();
    for (std::size_t i = block % choice.n; i < points.size(); i += choice.n) {
      thinned.push_back(points[i]);
      if (!of_points.empty()) labels.push_back(of_points[i]);
    }
    chooseByLabel(choice.choose, block++, thinned, labels, chosen);
    finite += points.size();
    tell(told, {points.size(), 0}, chosen);
    return true;
  });
  told({all.points - finite, all.invalid}, {}, 0);
}

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

  std::string labelField() const override { return header_.label ? header_.columns[*header_.label].name : ""; }

  std::optional<Eigen::Vector3d> viewpoint() const override {
    if (!header_.viewpoint) return std::nullopt;
    const auto& at = *header_.viewpoint;
    return Eigen::Vector3d(at[0], at[1], at[2]) * metres_per_unit_;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int threads, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    if (header_.encoding != PcdEncoding::Binary) return chooseInOrder(*this, origin, choice, block, told);
    constexpr std::uint64_t kRound = 64;  // blocks; a million rows between two calls of told
    const Frame frame{metres_per_unit_, origin};
    const std::uint64_t count = binaryBlockCount(header_);
    std::vector<std::vector<ChosenOfLabel>> chosen(kRound);
    std::vector<ScanCounts> read(kRound);
    for (std::uint64_t begin = 0; begin < count; begin += kRound) {
      const auto blocks = static_cast<std::size_t>(std::min(kRound, count - begin));
      forEachIndex(blocks, threads, [&](std::size_t i) {
        thread_local BlockBuffer buffer;
        const std::uint64_t number = block + begin + i;
        read[i] = decodeBinaryBlock(file_, header_, frame, {begin + i, {number % choice.n, choice.n}}, buffer);
        chooseByLabel(choice.choose, number, buffer.points, buffer.labels, chosen[i]);
      });
      for (std::size_t i = 0; i < blocks; ++i) tell(told, read[i], chosen[i]);
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
    ScanCounts counts;
    Points block;
    while (counts.points < rows_) {
      counts += fill(counts.points, {1.0, origin}, {}, block);
      if (!block.empty() && !visit(block, {})) break;
    }
    return counts;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    Points points, chosen;
    for (std::uint64_t begin = 0; begin < rows_; begin += kBlockRows, ++block) {
      const ScanCounts read = fill(begin, {1.0, origin}, {block % choice.n, choice.n}, points);
      chosen.clear();
      choice.choose(block, points, chosen);
      told(read, chosen, 0);
    }
  }

 private:
  /// Replaces points by the finite ones of the chosen rows of a block.
  ScanCounts fill(std::uint64_t begin, const Frame& frame, const RowChoice& rows, Points& points) const {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kBlockRows, rows_ - begin));
    ScanCounts counts{count, 0};
    points.clear();
    for (std::size_t i = 0, next = rows.first; i < count; ++i) {
      if (!appendFinite(row_(begin + i), frame, points)) {
        ++counts.invalid;
      } else if (i != next) {
        points.pop_back();
      }
      if (i == next) next += rows.step;
    }
    return counts;
  }

  std::uint64_t rows_;
  Scan::Row row_;
};

}  // namespace

std::shared_ptr<const Scan::Source> pcdSource(const std::string& path, double metres_per_unit) {
  return std::make_shared<PcdSource>(path, metres_per_unit);
}

std::shared_ptr<const Scan::Source> arraySource(std::uint64_t rows, Scan::Row row) {
  return std::make_shared<ArraySource>(rows, std::move(row));
}

}  // namespace tank_datum
