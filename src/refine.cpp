#include "tank_datum/refine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "circular_series.h"
#include "tank_datum/foot_check.h"
#include "tank_datum/foot_fit.h"
#include "tank_datum/harmonics.h"
#include "tank_datum/polar_ring.h"
#include "tank_datum/statistics.h"
#include "units.h"

namespace tank_datum {
namespace {

constexpr double kHighestWave = 0.03;  // bend of a datum times the radius: n^2 A / R for n = 8, A = R / 2000

/// The foot as the passes see it; vectors are indexed by station.
struct Foot {
  const FootRing& ring;
  const RefineOptions& options;
  double reach;                                ///< of the ring [m]
  double half_step;                            ///< half the angle between stations [rad]
  double radius;                               ///< of the shell, roughly [m]
  std::vector<double> directions;              ///< [rad]
  std::vector<std::vector<FootPoint>> points;  ///< of each station's own stretch
  std::vector<double> datum;                   ///< elevation as known so far, filled up in gaps [m]
  std::vector<FootFit> fits;
};

std::vector<ShellLine> fitShell(const std::vector<Station>& stations, const PolarRing& ring, const Tank& tank,
                                double reach) {
  const ShellOutline outline = outlineShell(ring, tank, reach);
  const double step = kTwoPi / static_cast<double>(stations.size());
  std::vector<ShellLine> lines(stations.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double azimuth = stations[i].direction;
    lines[i] = fitShellLine(ring, outline, azimuth, step, tank.foot(azimuth), 0.1 * reach, reach);
  }
  return lines;
}

ShellModel modelShell(std::vector<ShellLine> lines, const StationOptions& options) {
  if (options.clockwise) std::reverse(lines.begin() + 1, lines.end());
  return ShellModel(std::move(lines), options.zero_azimuth);
}

double noiseOf(const std::vector<ShellLine>& lines) {
  std::vector<double> noises;
  for (const ShellLine& line : lines) {
    if (line.seen()) noises.push_back(line.noise);
  }
  return median(noises);
}

/// Each station's own points, and a first elevation from those just outside the weld.
void lookFirst(Foot& foot, const Tank& tank, double weld) {
  std::vector<double> guesses;
  for (const double direction : foot.directions) {
    foot.points.push_back(foot.ring.around(direction, foot.half_step, tank.foot(direction), foot.reach));
    std::vector<double> heights;
    for (const FootPoint& p : foot.points.back()) {
      if (p.d >= weld && p.d <= weld + 0.1 * foot.reach) heights.push_back(p.z);
    }
    guesses.push_back(heights.size() < 5 ? FootFit::kUnknown : median(heights));
  }
  foot.datum = filledUp(runningMedian(guesses, 3));
}

/// Windows grow by borrowing from the neighbours until the standard error is what was asked for.
FootFit fitStation(const Foot& foot, std::size_t station, const FootProfile& profile, const FootPrior& prior) {
  const double azimuth = foot.directions[station], datum = foot.datum[station];
  for (double half = foot.half_step;; half *= 1.4) {
    const auto points = foot.ring.around(azimuth, half, datum, foot.reach);
    FootFit fit = fitFoot(points, profile, datum + profile.offset, prior.slope(azimuth), prior);
    fit.half_width = half;
    if (fit.sigma < foot.options.wanted_sigma || half * foot.radius > foot.options.widest_window) return fit;
  }
}

std::vector<FootFit> fitStations(const Foot& foot, const FootProfile& profile, const FootPrior& prior) {
  std::vector<FootFit> fits(foot.directions.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t i = 0; i < fits.size(); ++i) fits[i] = fitStation(foot, i, profile, prior);
  return fits;
}

/// The slope of a wide foundation surface round the tank, from windows ten degrees wide.
void learnSlope(const Foot& foot, const FootProfile& profile, FootPrior& prior) {
  constexpr double kHalfWindow = 5.0 * kPi / 180.0;
  constexpr double kLeastSigma = 0.003;  // no foundation is plane to better than 3 mm in a metre [m/m]
  std::vector<double> azimuths, slopes, weights;
  const std::size_t stride = std::max<std::size_t>(1, foot.directions.size() / 36);
  for (std::size_t i = 0; i < foot.directions.size(); i += stride) {
    const auto points = foot.ring.around(foot.directions[i], kHalfWindow, foot.datum[i], foot.reach);
    const FootFit fit = fitFoot(points, profile, foot.datum[i] + profile.offset, profile.slope, prior);
    if (!fit.valid()) continue;
    azimuths.push_back(foot.directions[i]);
    slopes.push_back(fit.slope);
    weights.push_back(1.0 / (fit.sigma_slope * fit.sigma_slope));
  }
  if (slopes.size() < 6) return;
  double mean = 0;
  for (const double w : weights) mean += w / static_cast<double>(weights.size());
  for (double& w : weights) w /= mean;
  prior.slope = fitHarmonics(azimuths, slopes, weights, 1, true, 0.02);
  const double among_windows = prior.slope.sigma * prior.slope.sigma - 1.0 / mean;
  prior.sigma_slope = std::max(kLeastSigma, std::sqrt(std::max(0.0, among_windows)));
}

FootPrior priorFor(const Foot& foot, const FootProfile& profile) {
  constexpr double kPlateSlope = 0.003;  // an annular plate lies on the ringwall's top to 0.2 mm in 65 [m/m]
  constexpr double kWideSlope = 0.1;     // of pads and floors, before they are looked at [m/m]
  FootPrior prior;
  prior.slope.coefficients = Eigen::Vector3d(profile.slope, 0.0, 0.0);
  prior.sigma_bend = kHighestWave / foot.radius;
  const bool plate = profile.surface == Surface::AnnularPlate;
  prior.sigma_slope = plate ? kPlateSlope : kWideSlope;
  if (!plate) learnSlope(foot, profile, prior);
  return prior;
}

/// How many points each station's own stretch has on the surface, and whether it lies between points of its neighbours.
struct Support {
  std::size_t own = 0;
  bool between = false;
};

Support supportOf(const Foot& foot, std::size_t station, const FootProfile& profile) {
  const double step = 2.0 * foot.half_step * foot.radius, azimuth = foot.directions[station];
  Support support;
  bool left = false, right = false;
  for (const FootPoint& p : foot.ring.around(azimuth, 2.0 * foot.half_step, foot.datum[station], foot.reach)) {
    if (p.d < profile.band_from || p.d > profile.band_to) continue;
    support.own += std::abs(p.t) <= 0.5 * step;
    (p.t < 0.0 ? left : right) = true;
  }
  support.between = left && right;
  return support;
}

/// A station is supported by points of its own; where the scan is so coarse that a stretch may be empty by chance, also
/// by points within a step on either side.
std::vector<bool> findSupport(const Foot& foot, const FootProfile& profile) {
  constexpr double kPlenty = 20.0;
  std::vector<Support> supports;
  std::vector<double> counts;
  for (std::size_t i = 0; i < foot.directions.size(); ++i) {
    supports.push_back(supportOf(foot, i, profile));
    if (supports[i].own > 0) counts.push_back(static_cast<double>(supports[i].own));
  }
  const bool coarse = median(counts) < kPlenty;
  std::vector<bool> supported;
  for (const Support& s : supports) supported.push_back(s.own > 0 || (coarse && s.between));
  return supported;
}

/// Stations whose fit has no support of its own, lies on something else, or steps off its neighbours.
std::vector<bool> findStrangers(const Foot& foot, const std::vector<ShellLine>& shell, const FootProfile& profile,
                                const FootPrior& prior) {
  const std::vector<bool> supported = findSupport(foot, profile);
  std::vector<FootFit> kept = foot.fits;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!shell[i].seen() || !kept[i].valid() || !supported[i] ||
        !isSameSurface(foot.points[i], kept[i], prior.slope(foot.directions[i]), profile)) {
      kept[i] = {};
    }
  }
  std::vector<bool> strange = findSteps(kept, 2.0 * foot.half_step * foot.radius);
  for (std::size_t i = 0; i < kept.size(); ++i) strange[i] = strange[i] || !kept[i].valid();
  return strange;
}

/// Elevations to stack the next section with: without strangers, unless they are most of what there is.
std::vector<double> withoutStrangers(const std::vector<double>& elevations, const std::vector<bool>& strange) {
  std::vector<double> kept = elevations;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (strange[i]) kept[i] = FootFit::kUnknown;
  }
  const auto known = [](double z) { return std::isfinite(z); };
  return 2 * std::count_if(kept.begin(), kept.end(), known) > std::count_if(elevations.begin(), elevations.end(), known)
             ? kept
             : elevations;
}

/// What the formal standard errors leave out: roughness common to a window's points, and blends that bend the section.
void widenSigmas(Foot& foot, const FootProfile& profile) {
  std::vector<double> widths;
  for (const FootFit& fit : foot.fits) {
    if (fit.valid()) widths.push_back(fit.half_width);
  }
  if (widths.empty()) return;
  const double ratio = birgeRatio(foot.fits, static_cast<std::size_t>(std::ceil(median(widths) / foot.half_step)));
  for (FootFit& fit : foot.fits) fit.sigma = std::hypot(ratio * fit.sigma, profile.misfit);
}

/// The circle of the shell at the datum.
Circle circleOf(const std::vector<Station>& stations, const Circle& start, double& sigma_radius) {
  std::vector<Eigen::Vector2d> plan;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) plan.emplace_back(s.x, s.y);
  }
  const Circle circle = fitCircle(plan, {}, start);
  if (!circle.valid()) return start;
  double squares = 0;
  for (const auto& p : plan) squares += circle.residual(p) * circle.residual(p);
  sigma_radius = std::sqrt(squares) / static_cast<double>(plan.size());
  return circle;
}

void fillStations(std::vector<Station>& stations, const Foot& foot, const std::vector<ShellLine>& shell,
                  const Eigen::Vector2d& center) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    Station& s = stations[i];
    const FootFit& fit = foot.fits[i];
    s.flag = fit.valid() ? StationFlag::Measured : StationFlag::Missing;
    s.x = s.y = s.z = s.sigma_z = s.radius = s.sigma_radius = Station::kUnknown;
    s.n_shell = shell[i].points;
    s.n_foundation = fit.points;
    if (!fit.valid()) continue;
    s.z = fit.z;
    s.sigma_z = fit.sigma;
    s.radius = shell[i].radius;
    s.sigma_radius = shell[i].sigma_radius;
    s.x = center.x() + s.radius * std::cos(s.direction);
    s.y = center.y() + s.radius * std::sin(s.direction);
  }
}

/// Stations stand at their azimuths about the fitted centre, which is millimetres from the one the fits went round: the
/// shell moves by that in radius, and its elevation by nothing that can be told.
void recentre(std::vector<Station>& stations, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  for (Station& s : stations) {
    if (s.flag != StationFlag::Measured) continue;
    const Eigen::Vector2d outwards(std::cos(s.direction), std::sin(s.direction));
    s.radius -= outwards.dot(to - from);
    s.x = to.x() + s.radius * outwards.x();
    s.y = to.y() + s.radius * outwards.y();
  }
}

}  // namespace

std::string firstError(const RefineOptions& options) {
  char text[96] = "";
  const auto refuse = [&text](const char* name, double value) {
    if (value > 0.0 || text[0] != '\0') return;
    std::snprintf(text, sizeof text, "refine.%s = %g m (must be > 0)", name, value);
  };
  refuse("largest_weld", options.largest_weld);
  refuse("widest_band", options.widest_band);
  refuse("widest_window", options.widest_window);
  refuse("wanted_sigma", options.wanted_sigma);
  return text;
}

Refined refineStations(std::vector<Station>& stations, const Ring& ring, const Tank& tank, const RefineOptions& options,
                       const StationOptions& station_options) {
  constexpr int kPasses = 3;  // the section sharpens as the stations' elevations do; a third pass moves nothing
  Refined refined;
  refined.circle = tank.circle;
  const PolarRing polar(ring.points, tank.circle.center);
  const auto shell = fitShell(stations, polar, tank, ring.reach);
  const double side = tank.side == Side::Outside ? 1.0 : -1.0, noise = noiseOf(shell);
  const FootRing foot_ring(polar, modelShell(shell, station_options), side, ring.reach);
  Foot foot{foot_ring, options, ring.reach, kPi / station_options.count, tank.circle.radius, {}, {}, {}, {}};
  for (const Station& s : stations) foot.directions.push_back(s.direction);

  const double weld = std::min(options.largest_weld, 0.05 * ring.reach);
  const FootScales scales{std::min(options.widest_band, ring.reach), noise, weld};
  lookFirst(foot, tank, weld);
  std::vector<double> to_stack = foot.datum;
  std::vector<bool> strange;
  for (int pass = 0; pass < kPasses; ++pass) {
    refined.profile = stackProfile(foot.points, to_stack, scales);
    if (!refined.profile.valid()) return refined;
    const FootPrior prior = priorFor(foot, refined.profile);
    foot.fits = fitStations(foot, refined.profile, prior);
    std::vector<double> elevations;
    for (const FootFit& fit : foot.fits) elevations.push_back(fit.z);
    strange = findStrangers(foot, shell, refined.profile, prior);
    to_stack = withoutStrangers(elevations, strange);
    foot.datum = filledUp(elevations);
  }
  for (std::size_t i = 0; i < strange.size(); ++i) {
    if (strange[i]) foot.fits[i] = {};
  }
  widenSigmas(foot, refined.profile);
  fillStations(stations, foot, shell, tank.circle.center);
  refined.circle = circleOf(stations, tank.circle, refined.sigma_radius);
  recentre(stations, tank.circle.center, refined.circle.center);
  std::vector<bool> measured;
  for (const Station& s : stations) measured.push_back(s.flag == StationFlag::Measured);
  flagGaps(stations, measured, station_options);
  bridgeGaps(stations, refined.circle.center, kHighestWave / tank.circle.radius);
  return refined;
}

}  // namespace tank_datum
