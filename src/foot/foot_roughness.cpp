#include "foot/foot_roughness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
double offOf(const FootPoint& p, const FootFit& fit) {
  return p.z - fit.z - fit.slope * p.d - fit.along * p.t - fit.bend * p.t * p.t;
}

bool isOfBand(const FootPoint& p, double off, const FootFit& fit, const FootProfile& profile) {
  constexpr double kStray = 4.0;  // standard deviations off a fit: no point of the surface
  return p.d >= profile.band_from && p.d < profile.band_to && std::abs(off) <= kStray * fit.noise;
}

double sharedAlong(double stretch, double length) {
  const double x = stretch / length;
  return std::sqrt(kTwoPi) / x * portable::erf(x / std::sqrt(2.0)) -
         2.0 / (x * x) * (1.0 - portable::exp(-0.5 * x * x));
}

namespace {

/// Variance of the means of a band's parts, beyond that of points that err alone, over the number of parts [m^2].
double roughnessIn(const std::vector<FittedPoints>& fits, const FootProfile& profile, std::size_t parts) {
  constexpr std::size_t kPlenty = 10;  // points of a part, on the average
  const double width = (profile.band_to - profile.band_from) / static_cast<double>(parts);
  double squares = 0, expected = 0, free = 0;
  for (const auto& [points, fit] : fits) {
    if (!fit.valid() || fit.points < kPlenty * parts) continue;
    std::vector<double> sums(parts, 0.0), counts(parts, 0.0);
    for (const FootPoint& p : points) {
      const double off = offOf(p, fit);
      if (!isOfBand(p, off, fit, profile)) continue;
      const auto part = std::min(parts - 1, static_cast<std::size_t>((p.d - profile.band_from) / width));
      sums[part] += off;
      counts[part] += 1.0;
    }
    double seen = 0;
    for (std::size_t k = 0; k < parts; ++k) {
      if (counts[k] < 1.0) continue;
      squares += sums[k] * sums[k] / (counts[k] * counts[k]);
      expected += fit.noise * fit.noise / counts[k];
      seen += 1.0;
    }
    free += std::max(0.0, seen - 1.0);  // the level is the fit's
  }
  if (free < 1.0) return 0.0;
  return std::max(0.0, squares - expected) / free / static_cast<double>(parts);
}

constexpr double kCell = 0.05;  // longer than most patches of a rough surface [m]

/// Residuals of a fit's points in cells of the band.
struct Cells {
  std::map<std::pair<long, long>, std::pair<double, double>> sums;  ///< of each cell: residuals, points
  double squares = 0, points = 0;

  void add(const FittedPoints& fitted, const FootProfile& profile, double width) {
    for (const FootPoint& p : fitted.points) {
      const double off = offOf(p, fitted.fit);
      if (!isOfBand(p, off, fitted.fit, profile)) continue;
      auto& [sum, count] = sums[{std::lround(p.t / kCell), std::lround((p.d - profile.band_from) / width - 0.5)}];
      sum += off, count += 1.0;
      squares += off * off, points += 1.0;
    }
  }
};

/// The length at which points of a cell share so much of their variance; of cells that are alike all over, their own.
double lengthSharing(double share, double width) {
  double low = 0.0, high = kCell;
  for (int i = 0; i < 40; ++i) {
    const double length = 0.5 * (low + high);
    (sharedAlong(kCell, length) * sharedAlong(width, length) < share ? low : high) = length;
  }
  return high;
}

}  // namespace

Roughness roughnessOf(const std::vector<FittedPoints>& fits, const FootProfile& profile, double noise) {
  constexpr double kUnknowns = 4.0;  // of a fit
  constexpr double kLeftOpen = 2.0;  // standard errors
  const double band = profile.band_to - profile.band_from, width = band / std::max(1.0, std::round(band / kCell));
  double squares = 0, free = 0, shared = 0, pairs = 0;
  for (const FittedPoints& fitted : fits) {
    if (!fitted.fit.valid()) continue;
    Cells cells;
    cells.add(fitted, profile, width);
    if (cells.points < 2.0 * kUnknowns) continue;
    const double variance = cells.squares / (cells.points - kUnknowns);
    squares += cells.squares, free += cells.points - kUnknowns;
    for (const auto& [place, cell] : cells.sums) {
      const auto& [sum, count] = cell;
      const double others = count * (count - 1.0);
      shared += sum * sum + others * variance * kUnknowns / cells.points;  // residuals of a fit cancel out
      pairs += others;
    }
    shared -= cells.squares;
  }
  if (!(free > 0.0) || !(pairs > 0.0)) return {};
  const double heights = squares / free - noise * noise;
  if (!(heights > 0.0)) return {};
  // patches as small as the pairs leave open, and no smaller than they can tell
  const double error = squares / free * std::sqrt(2.0 / pairs);
  const double common = std::max(shared / pairs - kLeftOpen * error, error);
  return {std::sqrt(heights), lengthSharing(common / heights, width)};
}

double sharedRoughness(const std::vector<FittedPoints>& fits, const FootProfile& profile) {
  // patches of a surface may be as long as a third of the band or as short as a sixth
  return std::max(roughnessIn(fits, profile, 3), roughnessIn(fits, profile, 6));
}

}  // namespace tank_datum
