#include "tank_datum/wall_map.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace tank_datum {
namespace {

using CellIndex = std::pair<std::int64_t, std::int64_t>;
using CellGrid = std::map<CellIndex, std::size_t>;

constexpr double kCellInVoxels = 2.0;
constexpr double kHoleInVoxels = 3.0;  // two empty voxels between hits are still one wall
constexpr double kRunInVoxels = 4.0;   // sloping or rough ground fills at most two voxels of a column

CellIndex cellOf(double x, double y, double cell) {
  return {static_cast<std::int64_t>(std::floor(x / cell)), static_cast<std::int64_t>(std::floor(y / cell))};
}

/// The longest stretch of height without a hole; the cell's position is the mean of its points.
WallCell longestRun(Points& column, double hole) {
  std::sort(column.begin(), column.end(), [](const auto& a, const auto& b) { return a.z() < b.z(); });
  std::size_t best_first = 0, best_last = 0;
  for (std::size_t first = 0, last = 0; first < column.size(); first = last + 1) {
    last = first;
    while (last + 1 < column.size() && column[last + 1].z() - column[last].z() <= hole) ++last;
    const double height = column[last].z() - column[first].z();
    if (height > column[best_last].z() - column[best_first].z()) {
      best_first = first;
      best_last = last;
    }
  }
  WallCell cell;
  cell.bottom = column[best_first].z();
  cell.top = column[best_last].z();
  cell.position.setZero();
  for (std::size_t i = best_first; i <= best_last; ++i) cell.position += column[i].head<2>();
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
  std::map<CellIndex, Points> columns;
  for (const auto& p : points) columns[cellOf(p.x(), p.y(), size)].push_back(p);

  std::vector<WallCell> cells;
  CellGrid grid;
  for (auto& [index, column] : columns) {
    const WallCell cell = longestRun(column, kHoleInVoxels * voxel);
    if (cell.top - cell.bottom < kRunInVoxels * voxel) continue;
    grid[index] = cells.size();
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
