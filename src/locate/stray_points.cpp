#include "locate/stray_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/bucket_sort.h"
#include "core/cell_number.h"
#include "core/parallel.h"
#include "core/parts.h"
#include "io/point_extent.h"

namespace tank_datum {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// A cell of the grid with the points in it.
struct PointsOfCell {
  Cell cell;
  std::uint32_t point;
};

using SortedPoints = std::vector<PointsOfCell, DefaultInitAllocator<PointsOfCell>>;

/// The points in the order of their cells: those of a row of cells along the third axis follow each other.
SortedPoints sortedByCell(const Points& points, double edge) {
  constexpr std::size_t kBuckets = 4096;
  SortedPoints sorted(points.size());
  forEachRun(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto index = [&](int axis) { return cellNumber(points[i][axis] / edge); };
      sorted[i] = {{index(0), index(1), index(2)}, static_cast<std::uint32_t>(i)};
    }
  });
  const auto by_cell = [](const PointsOfCell& a, const PointsOfCell& b) { return a.cell < b.cell; };
  const auto [low, high] = rangeOf(sorted.size(), 0, [&](std::size_t i) { return sorted[i].cell[0]; });
  const auto lowest = static_cast<double>(low);
  const double scale = static_cast<double>(kBuckets) / (static_cast<double>(high) - lowest + 1.0);
  const auto bucket_of = [&](const PointsOfCell& p) {
    return std::min(kBuckets - 1, static_cast<std::size_t>(scale * (static_cast<double>(p.cell[0]) - lowest)));
  };
  sortByBuckets(sorted, kBuckets, bucket_of, by_cell, 0);
  return sorted;
}

/// Counts the points in the three cells of one of the nine rows about a cell. Cells are asked for in their order, so
/// that the places of the row's first and last point only ever move on.
class RowCount {
 public:
  RowCount(const SortedPoints& sorted, std::int64_t along_first, std::int64_t along_second)
      : sorted_(sorted), offset_{along_first, along_second} {}

  /// Before the first cell that is asked for: a search in place of a walk.
  void startAt(const Cell& cell) {
    const auto before = [](const PointsOfCell& p, const Cell& wanted) { return p.cell < wanted; };
    begin_ = end_ = static_cast<std::size_t>(std::lower_bound(sorted_.begin(), sorted_.end(), lowestOf(cell), before) -
                                             sorted_.begin());
  }

  std::size_t at(const Cell& cell) {
    const Cell lowest = lowestOf(cell), highest = {lowest[0], lowest[1], cell[2] + 1};
    while (begin_ < sorted_.size() && sorted_[begin_].cell < lowest) ++begin_;
    end_ = std::max(begin_, end_);
    while (end_ < sorted_.size() && !(highest < sorted_[end_].cell)) ++end_;
    return end_ - begin_;
  }

 private:
  Cell lowestOf(const Cell& cell) const { return {cell[0] + offset_[0], cell[1] + offset_[1], cell[2] - 1}; }

  const SortedPoints& sorted_;
  std::array<std::int64_t, 2> offset_;
  std::size_t begin_ = 0, end_ = 0;
};

/// The nine rows about a cell, nearest first: of a point on a surface the first few tell that it has company.
std::vector<RowCount> rowsNearestFirst(const SortedPoints& sorted) {
  std::vector<RowCount> rows;
  for (const std::int64_t squared : {0, 1, 2}) {
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        if (i * i + j * j == squared) rows.emplace_back(sorted, i, j);
      }
    }
  }
  return rows;
}

/// Marks the points of a run of sorted ones that have less company than enough in their cell and the 26 about it.
void markAlone(const SortedPoints& sorted, std::size_t begin, std::size_t end, std::size_t enough,
               std::vector<char>& is_alone) {
  std::vector<RowCount> rows = rowsNearestFirst(sorted);
  for (RowCount& row : rows) row.startAt(sorted[begin].cell);
  bool alone = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (i == begin || sorted[i].cell != sorted[i - 1].cell) {
      std::size_t company = 0;
      for (std::size_t k = 0; k < rows.size() && company < enough; ++k) company += rows[k].at(sorted[i].cell);
      alone = company < enough;
    }
    is_alone[sorted[i].point] = static_cast<char>(alone);
  }
}

}  // namespace

void dropNoReturns(Points& points, const Eigen::Vector3d& zero) {
  const auto drop = [&points](const auto& is_out) {
    // most scans hold none, and all threads see that
    if (countWhere(points.size(), 0, [&](std::size_t i) { return is_out(points[i]); }) == 0) return;
    points.erase(std::remove_if(points.begin(), points.end(), is_out), points.end());
  };
  drop([&zero](const Eigen::Vector3d& p) { return p == zero; });
  if (points.empty()) return;
  const Extent extent = extentOf(points);
  drop([&extent](const Eigen::Vector3d& p) { return !extent.holds(p); });
}

bool holdsStrays(const VoxelSample& sample) {
  // Of the points, a share that may be alone where surfaces close: half are strays at most, a fifth of the others is
  // alone by chance. The sparse ends of clean scans are half as many as what counts as many further on.
  constexpr double kAlone = 0.6, kManyAtTwice = 0.15, kManyAtFourTimes = 0.05;
  const double closing = sample.edgeWithAlone(kAlone);
  return sample.shareAlone(2.0 * closing) > kManyAtTwice || sample.shareAlone(4.0 * closing) > kManyAtFourTimes;
}

double closingEdge(const VoxelSample& sample) {
  constexpr double kAlone = 0.7;  // of the points: soon enough that few strays have company
  return sample.edgeWithAlone(kAlone);
}

std::vector<char> findStrays(const Points& points, double edge) {
  constexpr std::size_t kCompany = 5;  // points in 27 cells, itself included; where surfaces close there are 18
  std::vector<char> is_stray(points.size());
  if (points.empty()) return is_stray;
  const SortedPoints sorted = sortedByCell(points, 2.0 * edge);
  forEachRun(sorted.size(), 0,
             [&](std::size_t begin, std::size_t end) { markAlone(sorted, begin, end, kCompany, is_stray); });
  // half are strays at most: where most are alone at this edge, it parts points that lie in pairs and fours
  constexpr double kMost = 0.6;
  const auto strays = std::count(is_stray.begin(), is_stray.end(), 1);
  if (static_cast<double>(strays) > kMost * static_cast<double>(points.size())) is_stray.assign(points.size(), 0);
  return is_stray;
}

Points withoutStrays(const Points& points, double edge) {
  const std::vector<char> is_stray = findStrays(points, edge);
  return concatenated(ofParts(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    Points of_part;
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_stray[i]) of_part.push_back(points[i]);
    }
    return of_part;
  }));
}

}  // namespace tank_datum
