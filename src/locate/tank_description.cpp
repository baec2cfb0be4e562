#include "locate/tank_description.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "fit/harmonics.h"
#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

constexpr double kShortOfRingwall = 0.075;  // half of the way to the face of the narrowest ringwall [m]

/// The circle through the shell's own points, over all of its height: the walls' cells know it to a share of a voxel
/// only. Tens of thousands of them, evenly spread, know it to a hundredth of a millimetre.
Circle refineCircle(const Points& points, double voxel, const Circle& circle, const PeriodicFit& foot, double band) {
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : points) {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    if (std::abs(arm.norm() - circle.radius) > band) continue;
    if (p.z() - foot(portable::atan2(arm.y(), arm.x())) > 2.0 * voxel) plan.push_back(p.head<2>());
  }
  constexpr std::size_t kPlenty = 50'000;
  const std::size_t stride = plan.size() / kPlenty + 1;
  std::vector<Eigen::Vector2d> thinned;
  for (std::size_t i = 0; i < plan.size(); i += stride) thinned.push_back(plan[i]);
  const Circle fitted = fitCircleRobust(thinned, circle);
  return fitted.valid() ? fitted : circle;
}

/// Whether walls step back over most of the azimuths at which they are seen.
/// @param steps  their heights, NaN where there is none [m]
bool standsOnRingwall(const std::vector<double>& steps) { return 2 * finiteOf(steps).size() > steps.size(); }

}  // namespace

PeriodicFit fitFootHeights(const std::vector<double>& azimuths, const std::vector<double>& feet, double window) {
  constexpr double kQuiet = 0.02;  // with a short arc the slope is what little data say, not an extrapolation
  PeriodicFit fit;
  fit.coefficients = Eigen::Vector3d(quantile(feet, 0.2), 0, 0);
  for (int iteration = 0; iteration < 5; ++iteration) {
    std::vector<double> near_azimuths, near_feet;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (std::abs(feet[i] - fit(azimuths[i])) > window) continue;
      near_azimuths.push_back(azimuths[i]);
      near_feet.push_back(feet[i]);
    }
    if (near_feet.empty()) break;
    fit = fitHarmonics(near_azimuths, near_feet, {}, {1, true, kQuiet});
  }
  return fit;
}

Tank describe(const Points& points, const Sample& sample, const Circle& circle, double rms, double least) {
  Tank tank;
  tank.circle = circle;
  tank.rms = rms;
  tank.resolution = sample.voxel;
  tank.strays = sample.strays;
  auto sectors = sectorsOf(points, sample.voxel, circle, std::max(1.5 * sample.voxel, 3.0 * rms));
  const double thickness = std::max(kShortOfRingwall, 3.0 * rms);
  std::vector<double> azimuths, feet, tops, steps, heights;
  std::vector<char> outside, inside;  // whether a foundation was seen on that side
  for (std::size_t s = 0; s < sectors.size(); ++s) {
    double bottom = 0, top = 0;
    if (!shellRun(sectors[s].shell, sample.voxel, thickness, bottom, top)) continue;
    azimuths.push_back((static_cast<double>(s) + 0.5) * kTwoPi / static_cast<double>(sectors.size()));
    feet.push_back(bottom);
    tops.push_back(top);
    steps.push_back(stepBackHeight(sectors[s].shell, sample.voxel, kShortOfRingwall));
    outside.push_back(hasFoundation(sectors[s].outside, bottom, sample.voxel, circle.radius));
    inside.push_back(hasFoundation(sectors[s].inside, bottom, sample.voxel, circle.radius));
  }
  if (standsOnRingwall(steps)) {
    feet = steps;
    for (std::size_t i = 0; i < steps.size(); ++i) outside[i] = std::isfinite(steps[i]), inside[i] = 0;
  }
  tank.coverage = kTwoPi * static_cast<double>(feet.size()) / static_cast<double>(sectors.size());
  for (std::size_t i = 0; i < feet.size(); ++i) heights.push_back(tops[i] - feet[i]);
  tank.height = median(finiteOf(heights));
  const auto seen_outside = std::count(outside.begin(), outside.end(), 1);
  const auto seen_inside = std::count(inside.begin(), inside.end(), 1);
  tank.side = seen_inside > seen_outside ? Side::Inside : Side::Outside;
  const auto& foundation = tank.side == Side::Inside ? inside : outside;
  const auto seen = static_cast<double>(std::max(seen_inside, seen_outside));
  tank.has_foundation = seen >= least * static_cast<double>(feet.size());
  for (std::size_t i = feet.size(); i-- > 0;) {  // a shell that ends above a shadow says nothing of the foot
    if (foundation[i] || !tank.has_foundation) continue;
    feet.erase(feet.begin() + static_cast<std::ptrdiff_t>(i));
    azimuths.erase(azimuths.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (!feet.empty()) tank.foot = fitFootHeights(azimuths, feet, 4.0 * sample.voxel + 0.02 * circle.radius);
  if (tank.foot.valid())
    tank.circle = refineCircle(points, sample.voxel, circle, tank.foot, std::max(1.5 * sample.voxel, 3.0 * rms));
  return tank;
}

}  // namespace tank_datum
