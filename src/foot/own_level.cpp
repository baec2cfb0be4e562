#include "foot/own_level.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/statistics.h"
#include "fit/surface_rows.h"

namespace tank_datum {

FootFit fitAtOwnLevel(const Foot& foot, std::size_t station, const FootPass& pass) {
  constexpr std::size_t kFewest = 12;  // points for four unknowns
  constexpr double kMost = 0.5;        // of the points that are seen: on the surface
  constexpr double kRough = 3.0;       // times the noise of the foot
  constexpr double kWide = 2.0;        // of half a step: a station's own stretch and half of those beside
  const FootProfile& profile = pass.sections.at(station);
  const double half_width = kWide * foot.half_step;
  const auto isInBand = [&](const FootPoint& p) { return p.d >= profile.band_from && p.d <= profile.band_to; };
  FootFit fit;
  std::vector<double> own;
  for (const FootPoint& p : foot.points[station]) {
    if (isInBand(p)) own.push_back(p.z);
  }
  if (own.empty()) return fit;
  SurfaceRows rows;
  foot.ring.visitAround(foot.directions[station], half_width, median(own), foot.reach, [&](const FootPoint& p) {
    if (isInBand(p)) rows.add(p.d, p.t, p.z);
  });
  if (rows.size() < kFewest) return fit;
  rows.close();
  const std::optional<SurfaceFit> seen = fitRobustly(rows);
  if (!seen || seen->noise > kRough * profile.noise) return fit;
  const auto used = std::count_if(rows.weights().begin(), rows.weights().end(), [](double w) { return w > 0.0; });
  if (static_cast<double>(used) < kMost * static_cast<double>(rows.size())) return fit;
  fit.points = static_cast<std::size_t>(used);
  fit.z = seen->solution[0], fit.slope = seen->solution[1];
  fit.along = seen->solution[2], fit.bend = seen->solution[3];
  fit.sigma = seen->noise * std::sqrt(seen->inverse(0, 0));
  fit.sigma_slope = seen->noise * std::sqrt(seen->inverse(1, 1));
  fit.noise = fit.own = seen->noise;
  fit.half_width = half_width;
  return fit;
}

}  // namespace tank_datum
