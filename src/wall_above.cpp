#include "wall_above.h"

#include "locate/foot_unit.h"
#include "locate/narrow_ringwall.h"
#include "locate/ring_shape.h"
#include "locate/step_back.h"

namespace tank_datum {

WallAbove::WallAbove(const Tank& tank, double reach, std::uint64_t points) {
  constexpr double kHalf = 0.2;      // of a band [footUnit]
  constexpr std::size_t kCell = 16;  // points of a band and half a degree
  if (!mayStandOnNarrowRingwall(tank)) return;
  const double unit = footUnit(tank.circle.radius, tank.resolution);
  ShellOptions options;
  options.half_band = unit * kHalf;
  options.reach = unit * (kWidestFace + kNarrowestFace);
  options.cell_points = kCell;
  for (double height = reachOf(tank, reach) + unit * kHalf; height < unit * (kHighestRingwall + kHalf);
       height += 2.0 * unit * kHalf)
    options.heights.push_back(height);
  if (!options.heights.empty()) bands_.emplace(tank, options, points);
}

Points WallAbove::points() const {
  Points all;
  if (!bands_) return all;
  for (std::size_t i = 0; i < bands_->heights().size(); ++i) {
    const Points more = bands_->points(i);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace tank_datum
