#include "upper_foot.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/statistics.h"
#include "locate/foot_unit.h"
#include "locate/narrow_ringwall.h"

namespace tank_datum {
namespace {

/// How far the stations of one datum lie below the foot of another's tank, in the middle [m].
double heightBelow(const Tank& tank, const std::vector<Station>& stations) {
  std::vector<double> heights;
  for (const Station& s : stations) {
    if (std::isfinite(s.z)) heights.push_back(tank.foot(s.direction) - s.z);
  }
  return median(std::move(heights));
}

/// Whether a foundation goes on beyond a step, at some azimuths, on the level of the foot.
bool goesOnBeyond(const FootProfile& profile, double step, double unit) {
  constexpr std::size_t kFewest = 5;  // bins, of which a few beside the step may be mixed
  constexpr double kLevel = 0.05;     // that a foundation falls by, and a lip is high, at most [footUnit]
  std::size_t seen = 0;
  for (std::size_t i = 0; i < profile.height.size(); ++i) {
    const double d = (static_cast<double>(i) + 0.5) * profile.bin;
    seen += d > step && std::abs(profile.height[i] - profile.offset) < kLevel * unit;
  }
  return seen >= kFewest;
}

}  // namespace

Datum upperOrLower(Datum upper, Datum lower) {
  constexpr double kWell = 0.06;  // below the step, as high as a ringwall's face is at least [footUnit]
  if (upper.usable() != lower.usable()) return upper.usable() ? upper : lower;
  if (!upper.usable()) return upper.hasStations() && !lower.hasStations() ? upper : lower;
  const double unit = footUnit(lower.tank.circle.radius, lower.tank.resolution);
  const bool is_on_plate = lower.refined.profile.surface == Surface::AnnularPlate;
  return is_on_plate && heightBelow(upper.tank, lower.stations) > kWell * unit ? lower : upper;
}

WallStep stepInDoubt(const Datum& datum, const std::optional<Tank>& upon) {
  constexpr double kApart = 0.02;  // of a lip's edge and the step's, at least [footUnit]
  const bool is_upon = datum.tank.standsOnRingwall();
  if (!datum.usable() || (!is_upon && !upon)) return {};
  const Tank& stepped = is_upon ? datum.tank : *upon;
  const double unit = footUnit(datum.tank.circle.radius, datum.tank.resolution);
  const double apart = kApart * unit, width = stepped.ringwall_width;
  const FootProfile& profile = datum.refined.profile;
  const bool is_lip = profile.surface == Surface::AnnularPlate && (!is_upon || profile.edge + apart < width);
  if (is_lip || width > kWidestFace * unit || (is_upon && goesOnBeyond(profile, width + apart, unit))) return {};
  return {width, stepped.ringwall_height};
}

}  // namespace tank_datum
