#include "tank_datum/foot/refine.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "foot/foot_check.h"
#include "foot/foot_fit.h"
#include "foot/foot_state.h"
#include "foot/polar_ring.h"
#include "foot/shell_circle.h"
#include "foot/shell_fits.h"
#include "foot/shell_line.h"
#include "foot/station_section.h"
#include "stations/highest_wave.h"
#include "tank_datum/core/parallel.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/harmonics.h"

namespace tank_datum {
namespace {

/// Windows grow by borrowing from the neighbours until the standard error is what was asked for: that of the level,
/// since the neighbours' points say no more about the slope than the prior does.
FootFit fitStation(const Foot& foot, std::size_t station, const FootProfile& profile, const FootPriors& priors) {
  constexpr double kWidestAngle = 10.0 * kPi / 180.0;     // of a curve that a parabola still follows
  constexpr double kKnownSlope = 0.003, kSettled = 1e-4;  // [m/m]
  constexpr double kGoodEnough = 2e-4;                    // to find the surface with [m]
  const FootPrior prior = priors.at(station);
  const double slope = priors.slope[station];
  const double azimuth = foot.directions[station], datum = foot.datum[station];
  const double widest = std::min(foot.options.widest_window / foot.radius, kWidestAngle);
  FootPrior level = prior;
  level.sigma_slope = priors.settled ? kSettled : std::min(prior.sigma_slope, kKnownSlope);
  for (double half = foot.half_step;; half *= 1.4) {
    const auto points = foot.ring.around(azimuth, half, datum, foot.reach);
    FootFit fit = fitFoot(points, profile, datum + profile.offset, slope, level);
    if (fit.sigma < std::max(kGoodEnough, foot.options.wanted_sigma) || half > widest) {
      if (priors.settled) {
        fit.sigma = std::hypot(fit.sigma, fit.middle * prior.sigma_slope);
      } else {
        fit = fitFoot(points, profile, datum + profile.offset, slope, prior);
      }
      fit.half_width = half;
      return fit;
    }
  }
}

std::vector<FootFit> fitStations(const Foot& foot, const FootSections& sections, const FootPriors& priors) {
  std::vector<FootFit> fits(foot.directions.size());
  forEachIndex(fits.size(), 0, [&](std::size_t i) {
    if (foot.believed[i]) fits[i] = fitStation(foot, i, sections.at(i), priors);
  });
  return fits;
}

/// What blends do to the section's level, as the arcs show it.
double misfitOf(const FootSections& sections) {
  if (sections.arcs.empty()) return sections.whole.misfit;
  std::vector<double> misfits;
  for (const FootProfile& arc : sections.arcs) misfits.push_back(arc.misfit);
  return median(misfits);
}

void fillStations(std::vector<Station>& stations, const Foot& foot, const std::vector<ShellLine>& shell,
                  const Eigen::Vector2d& center) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    Station& s = stations[i];
    const FootFit& fit = foot.fits[i];
    s.flag = fit.valid() ? StationFlag::Measured : StationFlag::Missing;
    s.x = s.y = s.z = s.sigma_z = s.radius = s.sigma_radius = s.window = kUnknown;
    s.n_shell = shell[i].points;
    s.n_foundation = fit.points;
    if (!fit.valid()) continue;
    s.z = fit.z;
    s.sigma_z = fit.sigma;
    s.window = 2.0 * fit.half_width;
    s.radius = shell[i].radius;
    s.sigma_radius = shell[i].sigma_radius;
    s.x = center.x() + s.radius * std::cos(s.direction);
    s.y = center.y() + s.radius * std::sin(s.direction);
  }
}

/// What the report shows of each station; a stranger's points are shown without the line that was refused.
std::vector<StationProfile> sectionsOf(const Foot& foot, const std::vector<ShellLine>& shell, double band_to,
                                       double side) {
  std::vector<StationProfile> sections;
  if (foot.options.profile_points == 0) return sections;
  sections.resize(foot.fits.size());
  forEachIndex(sections.size(), 0, [&](std::size_t i) {
    const ProfileWindow window{foot.directions[i], foot.half_step, foot.datum[i], foot.reach, band_to, side};
    sections[i] = profileOf(foot.ring, window, foot.fits[i], shell[i], foot.options.profile_points);
  });
  return sections;
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

Refined refineStations(std::vector<Station>& stations, const Ring& ring, const Tank& tank, const RefineOptions& options,
                       const StationOptions& station_options) {
  constexpr int kFewest = 360;  // stations that follow the shell's lobes; fewer are picked from as many
  if (station_options.count < kFewest) {
    const int every = (kFewest + station_options.count - 1) / station_options.count;
    StationOptions fine_options = station_options;
    fine_options.count *= every;
    std::vector<Station> fine = emptyStations(fine_options);
    Refined refined = refineStations(fine, ring, tank, options, fine_options);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Station coarse = stations[i];
      stations[i] = fine[i * static_cast<std::size_t>(every)];
      stations[i].azimuth = coarse.azimuth;
      stations[i].z_paper = coarse.z_paper;
      if (!refined.sections.empty()) refined.sections[i] = refined.sections[i * static_cast<std::size_t>(every)];
    }
    if (!refined.sections.empty()) refined.sections.resize(stations.size());
    return refined;
  }
  constexpr int kPasses = 3;  // the section sharpens as the elevations do; the third moves a few stations by 0.1 mm
  Refined refined;
  refined.circle = tank.circle;
  const PolarRing polar(ring.points, tank.circle.center);
  const ShellFits fits = fitShell(stations, polar, tank, ring.reach);
  const auto& shell = fits.lines;
  const double side = tank.side == Side::Outside ? 1.0 : -1.0, noise = fits.noise();
  if (!(noise > 0.0)) return refined;  // no shell line anywhere
  const FootRing foot_ring(polar, modelShell(shell, station_options), side, ring.reach);
  Foot foot{foot_ring, options, ring.reach, kPi / station_options.count, tank.circle.radius, {}, {}, {}, {}, {}};
  for (const Station& s : stations) foot.directions.push_back(s.direction);

  const double weld = std::min(options.largest_weld, 0.05 * ring.reach);
  const FootScales scales{std::min(options.widest_band, ring.reach), noise, weld};
  std::vector<double> to_stack = lookFirst(foot, tank, scales);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    if (!shell[i].seen()) to_stack[i] = kUnknown;
  }
  std::vector<bool> strange;
  FootSections sections;
  FootPriors priors;
  for (int pass = 0; pass < kPasses; ++pass) {
    sections = stackSections(foot, to_stack, scales);
    refined.profile = sections.whole;
    priors = learnPriors(foot, sections);
    foot.fits = fitStations(foot, sections, priors);
    std::vector<double> elevations;
    for (const FootFit& fit : foot.fits) elevations.push_back(fit.z);
    strange = findStrangers(foot, shell, sections, priors);
    to_stack = withoutStrangers(elevations, strange);
    foot.datum = filledUp(elevations);
  }
  for (std::size_t i = 0; i < strange.size(); ++i) {
    if (strange[i]) foot.fits[i] = {};
  }
  RingProcess process;
  if (isResolved(foot, scales)) process = levelStations(foot, sections, priors, misfitOf(sections));
  refined.sections = sectionsOf(foot, shell, refined.profile.band_to, side);
  fillStations(stations, foot, shell, tank.circle.center);
  const ShellCircle round = fitShellCircle(fits.lines, foot.directions, fits.from, fits.to, tank.circle, priorOf(tank));
  refined.circle = round.circle;
  refined.sigma_radius = round.sigma_radius;
  recentre(stations, tank.circle.center, refined.circle.center);
  std::vector<bool> measured;
  for (const Station& s : stations) measured.push_back(s.flag == StationFlag::Measured);
  flagGaps(stations, measured, station_options);
  bridgeGaps(stations, refined.circle.center, kHighestWave / tank.circle.radius);
  for (std::size_t i = 0; i < stations.size() && process.valid(); ++i) {
    if (stations[i].flag == StationFlag::Interpolated)
      stations[i].z = process.value[i], stations[i].sigma_z = std::max(stations[i].sigma_z, process.sigma[i]);
  }
  return refined;
}

}  // namespace tank_datum
