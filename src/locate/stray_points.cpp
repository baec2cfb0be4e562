#include "locate/stray_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/cell_number.h"
#include "core/parallel.h"
#include "core/point_hash.h"
#include "io/point_extent.h"

namespace tank_datum {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t i : cell) hash = mixed(hash ^ static_cast<std::uint64_t>(i));
    return hash;
  }
};

Cell cellOf(const Eigen::Vector3d& p, double edge) {
  const auto index = [&](int axis) { return cellNumber(p[axis] / edge); };
  return {index(0), index(1), index(2)};
}

using CellCounts = std::unordered_map<Cell, std::uint32_t, CellHash>;

/// The 27 cells about one, nearest first: of a point on a surface the first few tell that it has company.
std::array<Cell, 27> offsetsNearestFirst() {
  std::array<Cell, 27> offsets;
  for (std::int64_t i = 0; i < 27; ++i) offsets[static_cast<std::size_t>(i)] = {i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1};
  const auto squared = [](const Cell& c) { return c[0] * c[0] + c[1] * c[1] + c[2] * c[2]; };
  std::stable_sort(offsets.begin(), offsets.end(),
                   [&](const Cell& a, const Cell& b) { return squared(a) < squared(b); });
  return offsets;
}

bool hasCompany(const CellCounts& counts, const Cell& cell, std::uint32_t enough) {
  static const std::array<Cell, 27> offsets = offsetsNearestFirst();
  std::uint32_t sum = 0;
  for (const Cell& offset : offsets) {
    const auto found = counts.find({cell[0] + offset[0], cell[1] + offset[1], cell[2] + offset[2]});
    if (found != counts.end()) sum += found->second;
    if (sum >= enough) return true;
  }
  return false;
}

}  // namespace

void dropNoReturns(Points& points, const Eigen::Vector3d& zero) {
  const auto drop = [&points](const auto& is_out) {
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
  constexpr std::uint32_t kCompany = 5;  // points in 27 cells, itself included; where surfaces close there are 18
  const double cell = 2.0 * edge;
  CellCounts counts;
  counts.reserve(points.size());
  for (const auto& p : points) ++counts[cellOf(p, cell)];
  std::vector<char> is_stray(points.size());
  forEachRun(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) is_stray[i] = !hasCompany(counts, cellOf(points[i], cell), kCompany);
  });
  // half are strays at most: where most are alone at this edge, it parts points that lie in pairs and fours
  constexpr double kMost = 0.6;
  const auto strays = std::count(is_stray.begin(), is_stray.end(), 1);
  if (static_cast<double>(strays) > kMost * static_cast<double>(points.size())) is_stray.assign(points.size(), 0);
  return is_stray;
}

Points withoutStrays(const Points& points, double edge) {
  const std::vector<char> is_stray = findStrays(points, edge);
  Points kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_stray[i]) kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace tank_datum
