#include "locate/wall_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/cell_number.h"
#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

using CellIndex = std::pair<std::int64_t, std::int64_t>;
using CellGrid = std::map<CellIndex, std::size_t>;

constexpr double kCellInVoxels = 2.0;
constexpr double kRunInVoxels = 4.0;  // sloping or rough ground fills at most two voxels of a column

CellIndex cellOf(double x, double y, double cell) { return {cellNumber(x / cell), cellNumber(y / cell)}; }

/// A point filed by its cell.
struct Filed {
  CellIndex cell;
  Eigen::Vector3d point;
};

/// The longest stretch of height without a hole of one cell's points, sorted by height; the cell's position is the mean
/// of its points.
WallCell longestRun(const Filed* first, const Filed* end, double hole) {
  const Filed *best_first = first, *best_last = first;
  for (const Filed *from = first, *to = first; from < end; from = to + 1) {
    to = from;
    while (to + 1 < end && to[1].point.z() - to->point.z() <= hole) ++to;
    const double height = to->point.z() - from->point.z();
    if (height > best_last->point.z() - best_first->point.z()) {
      best_first = from;
      best_last = to;
    }
  }
  WallCell cell;
  cell.bottom = best_first->point.z();
  cell.top = best_last->point.z();
  cell.position.setZero();
  for (const Filed* filed = best_first; filed <= best_last; ++filed) cell.position += filed->point.head<2>();
  cell.position /= static_cast<double>(best_last - best_first + 1);
  return cell;
}

/// Across the line through the cells around this one; zero where they do not line up.
Eigen::Vector2d normalAt(const std::vector<WallCell>& cells, const CellGrid& grid, const CellIndex& at) {
  constexpr std::int64_t kReach = 2;
  std::vector<Eigen::Vector2d> around;
  for (std::int64_t dx = -kReach; dx <= kReach; ++dx) {
    for (std::int64_t dy = -kReach; dy <= kReach; ++dy) {
      const auto found = grid.find({at.first + dx, at.second + dy});
      if (found != grid.end()) around.push_back(cells[found->second].position);
    }
  }
  if (around.size() < 3) return Eigen::Vector2d::Zero();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : around) mean += p / static_cast<double>(around.size());
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& p : around) covariance += (p - mean) * (p - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance);
  constexpr double kStraight = 0.15;  // variance across the wall over variance along it
  if (solver.eigenvalues()[0] > kStraight * solver.eigenvalues()[1]) return Eigen::Vector2d::Zero();
  return solver.eigenvectors().col(0);
}

}  // namespace

std::vector<WallCell> mapWalls(const Points& points, double voxel) {
  const double size = kCellInVoxels * voxel;
  std::vector<Filed> filed;
  filed.reserve(points.size());
  for (const auto& p : points) filed.push_back({cellOf(p.x(), p.y(), size), p});
  std::sort(filed.begin(), filed.end(), [](const Filed& a, const Filed& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.point.z() < b.point.z();
  });

  std::vector<WallCell> cells;
  CellGrid grid;
  for (std::size_t first = 0, end = 0; first < filed.size(); first = end) {
    while (end < filed.size() && filed[end].cell == filed[first].cell) ++end;
    const WallCell cell = longestRun(&filed[first], &filed[first] + (end - first), kHoleInVoxels * voxel);
    if (cell.top - cell.bottom < kRunInVoxels * voxel) continue;
    grid[filed[first].cell] = cells.size();
    cells.push_back(cell);
  }
  std::vector<WallCell> walls;
  for (const auto& [index, at] : grid) {
    cells[at].normal = normalAt(cells, grid, index);
    if (!cells[at].normal.isZero()) walls.push_back(cells[at]);
  }
  return walls;
}

}  // namespace tank_datum
