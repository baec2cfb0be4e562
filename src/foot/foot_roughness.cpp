#include "foot/foot_roughness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
double offOf(const FootPoint& p, const FootFit& fit) {
  return p.z - fit.z - fit.slope * p.d - fit.along * p.t - fit.bend * p.t * p.t;
}

FootPoint metAt(const FootPoint& p, double off, const FittedPoints& fitted) {
  return {p.t, p.d - off / fitted.steepness, p.z};
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

/// A variance and its standard error [m^2].
struct Variance {
  double value = 0, error = 0;
};

/// Variance of the means of a band's parts, beyond that of points that err alone, over the number of parts (analysis of
/// variance: a part counts for its points). Points are parted where their rays would meet the fit: a row that stays on
/// one place of a narrow lip is parted by its points' heights else.
Variance roughnessIn(const std::vector<FittedPoints>& fits, const FootProfile& profile, std::size_t parts) {
  constexpr std::size_t kPlenty = 10;  // points of a part, on the average
  const double width = (profile.band_to - profile.band_from) / static_cast<double>(parts);
  double squares = 0, expected = 0, free = 0, shared = 0;
  for (const FittedPoints& fitted : fits) {
    const FootFit& fit = fitted.fit;
    if (!fit.valid() || fit.points < kPlenty * parts) continue;
    std::vector<double> sums(parts, 0.0), counts(parts, 0.0);
    for (const FootPoint& p : fitted.points) {
      const double off = offOf(p, fit);
      const FootPoint met = metAt(p, off, fitted);
      if (!isOfBand(met, off, fit, profile)) continue;
      const auto part = std::min(parts - 1, static_cast<std::size_t>((met.d - profile.band_from) / width));
      sums[part] += off;
      counts[part] += 1.0;
    }
    double seen = 0, sum = 0, points = 0, of_parts = 0;
    for (std::size_t k = 0; k < parts; ++k) {
      if (counts[k] < 1.0) continue;
      squares += sums[k] * sums[k] / counts[k];
      seen += 1.0, sum += sums[k], points += counts[k], of_parts += counts[k] * counts[k];
    }
    if (seen < 1.0) continue;
    squares -= sum * sum / points;  // the level is the fit's
    expected += (seen - 1.0) * fit.noise * fit.noise;
    free += seen - 1.0, shared += points - of_parts / points;
  }
  if (free < 1.0) return {};
  const double each = shared * static_cast<double>(parts);
  return {std::max(0.0, squares - expected) / each, std::sqrt(2.0 / free) * squares / each};
}

constexpr double kCell = 0.05;  // longer than most patches of a rough surface [m]

/// Points of a fit on the band, each with its residual for z, in cells where their rays would meet the fit.
using Cells = std::map<std::pair<long, long>, std::vector<FootPoint>>;

Cells cellsOf(const FittedPoints& fitted, const FootProfile& profile) {
  const double band = profile.band_to - profile.band_from, width = band / std::max(1.0, std::round(band / kCell));
  Cells cells;
  for (const FootPoint& p : fitted.points) {
    const double off = offOf(p, fitted.fit);
    if (!isOfBand(p, off, fitted.fit, profile)) continue;
    const double d = metAt(p, off, fitted).d;
    cells[{std::lround(p.t / kCell), std::lround((d - profile.band_from) / width - 0.5)}].push_back({p.t, d, off});
  }
  return cells;
}

/// Pairs of points that share a cell: what their residuals have in common, and how far they lie apart.
class CellPairs {
 public:
  void add(const Cells& cells) {
    constexpr double kUnknowns = 4.0;  // of a fit
    double squares = 0, points = 0;
    for (const auto& [place, all] : cells) {
      for (const FootPoint& p : all) squares += p.z * p.z, points += 1.0;
    }
    if (points < 2.0 * kUnknowns) return;
    squares_ += squares, free_ += points - kUnknowns;
    const double taken = squares / (points - kUnknowns) * kUnknowns / points;  // residuals of a fit cancel out
    for (const auto& [place, all] : cells) addPairs(all, taken);
  }

  bool any() const { return free_ > 0.0 && pairs_ > 0.0; }
  double variance() const { return squares_ / free_; }
  double shared() const { return shared_ / pairs_; }               ///< mean product [m^2]
  double error() const { return variance() / std::sqrt(pairs_); }  ///< of it, by chance [m^2]

  /// The length of patches of which pairs share so much of their variance, from the shortest to a cell's own.
  double lengthSharing(double share) const {
    double low = kShortest, high = kCell;
    for (int i = 0; i < 40; ++i) {
      const double length = 0.5 * (low + high);
      (shareAt(length) < share ? low : high) = length;
    }
    return high;
  }

 private:
  static constexpr double kShortest = 0.005;  // of the patches of pads and plates [m]
  static constexpr double kStep = 0.001;      // of distances [m]

  void addPairs(const std::vector<FootPoint>& all, double taken) {
    constexpr std::size_t kMost = 50;  // points of a cell
    const std::size_t count = std::min(kMost, all.size());
    for (std::size_t i = 1; i < count; ++i) {
      const FootPoint& p = all[i * all.size() / count];
      for (std::size_t j = 0; j < i; ++j) {
        const FootPoint& q = all[j * all.size() / count];
        shared_ += p.z * q.z + taken, pairs_ += 1.0;
        const auto apart = static_cast<std::size_t>(std::hypot(p.t - q.t, p.d - q.d) / kStep);
        apart_[std::min(apart, apart_.size() - 1)] += 1.0;  // rays that all but miss the surface round their distances
      }
    }
  }

  double shareAt(double length) const {
    double sum = 0;
    for (std::size_t k = 0; k < apart_.size(); ++k) {
      const double x = (static_cast<double>(k) + 0.5) * kStep / length;
      sum += apart_[k] * portable::exp(-0.5 * x * x);
    }
    return sum / pairs_;
  }

  double squares_ = 0, free_ = 0, shared_ = 0, pairs_ = 0;
  std::array<double, 100> apart_{};  ///< pairs by their distance: a cell is a tenth of a metre across at most
};

}  // namespace

Roughness roughnessOf(const std::vector<FittedPoints>& fits, const FootProfile& profile, double noise) {
  constexpr double kLeftOpen = 2.0;  // standard errors
  CellPairs pairs;
  for (const FittedPoints& fitted : fits) {
    if (fitted.fit.valid() && fitted.steepness > 0.0) pairs.add(cellsOf(fitted, profile));
  }
  if (!pairs.any()) return {};
  const double heights = pairs.variance() - noise * noise;
  if (!(heights > 0.0)) return {};
  // patches as short as the pairs leave open; where that is less than they can tell, the middle of what they cannot
  const double shortest = pairs.lengthSharing((pairs.shared() - kLeftOpen * pairs.error()) / heights);
  const double told = pairs.lengthSharing(pairs.error() / heights);
  return {std::sqrt(heights), std::max(shortest, std::sqrt(shortest * told))};
}

double sharedRoughness(const std::vector<FittedPoints>& fits, const FootProfile& profile) {
  // patches of a surface may be as long as a third of the band or as short as a sixth, which few fits may have to tell
  const Variance sixths = roughnessIn(fits, profile, 6);
  return std::max(roughnessIn(fits, profile, 3).value, sixths.value - sixths.error);
}

}  // namespace tank_datum
