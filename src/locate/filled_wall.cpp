#include "locate/filled_wall.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

/// Whether heights behind a wall lie beside its upper half and above only: strays, and what a shell mirrors, lie lower
/// as well.
bool isFilled(const std::vector<double>& heights, double bottom, double top) {
  constexpr double kBelow = 0.1;  // of what lies above
  const double half = 0.5 * (top - bottom), middle = bottom + half;
  std::size_t above = 0, below = 0;
  for (const double z : heights) {
    above += z > middle && z < top + half;
    below += z > bottom - half && z <= middle;
  }
  return above > 0 && static_cast<double>(below) < kBelow * static_cast<double>(above);
}

}  // namespace

double shareFilled(const Points& points, double voxel, const Tank& tank) {
  constexpr double kLowest = 1.2;    // [m]
  constexpr double kOfRadius = 0.4;  // tins, and the smallest tanks
  if (tank.height > std::min(kLowest, kOfRadius * tank.circle.radius)) return 0.0;
  std::size_t stand = 0, filled = 0;
  for (Sector& sector : sectorsOf(points, voxel, tank.circle, bandOf(voxel, tank.rms))) {
    const auto run = shellRun(std::move(sector.shell), voxel, thicknessOf(tank.rms));
    if (!run) continue;
    ++stand, filled += isFilled(sector.farther_in, run->bottom, run->top);
  }
  return stand > 0 ? static_cast<double>(filled) / static_cast<double>(stand) : 0.0;
}

}  // namespace tank_datum
