#include "locate/walls_behind.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "locate/arc_meter.h"
#include "locate/side_sign.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSectors = 72;

struct SectorView {
  bool seen = false;
  int walls = 0;          ///< behind
  double furthest = 0.0;  ///< [m]
};

}  // namespace

WallsBehind wallsBehind(const std::vector<WallCell>& walls, const Tank& tank) {
  constexpr double kClear = 0.2;    // of the radius: a mug's wall is a tenth of it thick, a pilaster's less
  constexpr double kWithin = 0.02;  // of the radius: the shell itself
  constexpr int kWall = 2;          // cells; a single one may be a pole
  const Circle& circle = tank.circle;
  const double clear = std::max(kClear * circle.radius, 4.0 * tank.resolution);
  const StandingRule shell{tank.resolution + kWithin * circle.radius, kFacing};
  std::array<SectorView, kSectors> sectors;
  for (const WallCell& wall : walls) {
    const Eigen::Vector2d arm = wall.position - circle.center;
    const double azimuth = tank.azimuthOf(wall.position), foot = tank.foot(azimuth);
    SectorView& sector = sectors[static_cast<std::size_t>(azimuth / kTwoPi * kSectors) % kSectors];
    if (shell.holds(wall, circle)) sector.seen = true;
    const double behind = signOf(tank.side) * (circle.radius - arm.norm());
    const double shared = std::min(wall.top, foot + tank.height) - std::max(wall.bottom, foot);
    if (behind < clear || behind > circle.radius || shared < 3.0 * tank.resolution) continue;
    ++sector.walls;
    sector.furthest = std::max(sector.furthest, behind);
  }
  std::size_t seen = 0;
  std::vector<double> distances;
  for (const SectorView& sector : sectors) {
    if (!sector.seen) continue;
    ++seen;
    if (sector.walls >= kWall) distances.push_back(sector.furthest);
  }
  if (distances.empty()) return {};
  return {static_cast<double>(distances.size()) / static_cast<double>(seen), median(distances)};
}

}  // namespace tank_datum
