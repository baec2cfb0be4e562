#include "locate/foot_heights.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/statistics.h"
#include "fit/harmonics.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

PeriodicFit fitNear(const std::vector<double>& feet, double within) {
  constexpr double kQuiet = 0.02;  // with a short arc the slope is what little data say, not an extrapolation
  PeriodicFit fit;
  fit.coefficients = Eigen::Vector3d(quantile(finiteOf(feet), 0.2), 0, 0);
  for (int iteration = 0; iteration < 5; ++iteration) {
    std::vector<double> near_azimuths, near_feet;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      const double azimuth = middleOfCell(i, feet.size());
      if (!(std::abs(feet[i] - fit(azimuth)) <= within)) continue;
      near_azimuths.push_back(azimuth);
      near_feet.push_back(feet[i]);
    }
    if (near_feet.empty()) break;
    fit = fitHarmonics(near_azimuths, near_feet, {}, {1, true, kQuiet});
  }
  return fit;
}

/// How far below the fit the lowest arc is in which most feet agree; 0 where there is none.
double lowestArcBelow(const PeriodicFit& fit, const std::vector<double>& feet, double voxel) {
  constexpr double kMost = 0.75;
  constexpr double kAgree = 3.0;  // voxels, two of them empty between the lowest points of a wall
  const auto count = static_cast<std::size_t>(std::lround(kFoundationArc / kTwoPi * static_cast<double>(feet.size())));
  const auto most = static_cast<std::ptrdiff_t>(std::ceil(kMost * static_cast<double>(count)));
  double lowest = 0.0;
  for (std::size_t first = 0; first < feet.size(); ++first) {
    std::vector<double> below;
    for (std::size_t i = first; i < first + count; ++i) {
      const std::size_t sector = i % feet.size();
      if (std::isfinite(feet[sector])) below.push_back(fit(middleOfCell(sector, feet.size())) - feet[sector]);
    }
    const double arc = median(below);
    const auto agree =
        std::count_if(below.begin(), below.end(), [&](double b) { return std::abs(b - arc) <= kAgree * voxel; });
    if (agree >= most) lowest = std::max(lowest, arc);
  }
  return lowest;
}

}  // namespace

PeriodicFit fitFootHeights(const std::vector<double>& feet, double voxel, const FootWindow& window) {
  if (finiteOf(feet).empty()) return {};
  PeriodicFit fit = fitNear(feet, window.from_fit);
  fit.coefficients[0] -= std::max(0.0, lowestArcBelow(fit, feet, voxel) - window.below_fit);
  return fit;
}

}  // namespace tank_datum
