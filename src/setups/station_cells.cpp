#include "setups/station_cells.h"

#include <cmath>

#include "core/portable_math.h"
#include "core/units.h"
#include "locate/side_sign.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

StationCells::StationCells(const std::vector<Station>& stations) {
  constexpr std::size_t kFewestCells = 360;
  const std::size_t count = stations.size() * ((kFewestCells + stations.size() - 1) / stations.size());
  first_ = stations.front().direction;
  step_ = kTwoPi / static_cast<double>(count);
  levels_.assign(count, {kUnknown, kUnknown});
  for (const Station& s : stations) {
    if (std::isfinite(s.z) && std::isfinite(s.radius)) levels_[cellOf(s.direction)] = {s.radius, s.z};
  }
  const std::vector<StationLevel> known = levels_;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t away = 1; away < count / 2 && std::isnan(levels_[i].z); ++away) {
      for (const std::size_t j : {(i + away) % count, (i + count - away) % count}) {
        if (std::isnan(levels_[i].z) && std::isfinite(known[j].z)) levels_[i] = known[j];
      }
    }
  }
}

std::size_t StationCells::cellOf(double direction) const {
  const double turn = (direction - first_) / kTwoPi;
  return static_cast<std::size_t>(std::lround((turn - std::floor(turn)) * static_cast<double>(count()))) % count();
}

FootPlace StationCells::placeOf(const Eigen::Vector3d& point, const Eigen::Vector2d& center, Side side) const {
  const Eigen::Vector2d arm = point.head<2>() - center;
  const double azimuth = portable::atan2(arm.y(), arm.x());
  const std::size_t cell = cellOf(azimuth);
  return {cell, azimuth, signOf(side) * (arm.norm() - levels_[cell].radius), point.z() - levels_[cell].z};
}

}  // namespace tank_datum
