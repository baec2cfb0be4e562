#include "foot/refine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "foot/foot_bridges.h"
#include "foot/foot_doubts.h"
#include "foot/foot_passes.h"
#include "foot/foot_profile.h"
#include "foot/foot_shadows.h"
#include "foot/foot_state.h"
#include "foot/narrow_lips.h"
#include "foot/other_walls.h"
#include "foot/polar_ring.h"
#include "foot/raised_foot.h"
#include "foot/section_end.h"
#include "foot/shell_below.h"
#include "foot/shell_circle.h"
#include "foot/shell_fits.h"
#include "foot/shell_line.h"
#include "foot/station_section.h"
#include "locate/side_sign.h"
#include "stations/highest_wave.h"
#include "stations/ring_series.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

/// The stations that the foot is fitted at: those asked for, and between them as many as follow the shell's lobes. They
/// run counter-clockwise from +x on, so that the way stations are counted moves no result.
StationOptions fittedStations(StationOptions options) {
  constexpr int kLeastStations = 360;
  constexpr double kRounding = 1e-9;  // of a step
  options.count *= std::max(1, (kLeastStations + options.count - 1) / options.count);
  const double step = kTwoPi / options.count;
  options.zero_azimuth -= step * std::floor(options.zero_azimuth / step + kRounding);
  options.clockwise = false;
  return options;
}

std::vector<double> directionsOf(const StationOptions& options) {
  std::vector<double> directions;
  for (const Station& s : emptyStations(options)) directions.push_back(s.direction);
  return directions;
}

/// What the passes look at, each station's own points among it.
/// @param polar  taken over
Foot lookAtFoot(PolarRing polar, const ShellFits& shell, const Tank& tank, const RefineOptions& options,
                const StationOptions& station_options, double rounding) {
  const double reach = shell.heights.to;
  const double weld = std::min(options.largest_weld, 0.05 * reach);
  const FootScales scales{std::min(options.widest_band, reach), shell.noise(), weld};
  Foot foot{FootRing(std::move(polar), ShellModel(shell.lines, station_options.zero_azimuth), signOf(tank.side), reach),
            options,
            scales,
            reach,
            kPi / station_options.count,
            tank.circle.radius,
            rounding,
            directionsOf(station_options),
            {},
            {},
            tank.side == Side::Inside};
  if (isResolved(foot)) foot.ring.leaveOutUprights(tank, scales.nearest(), reach);
  for (const ShellLine& line : shell.lines) foot.shell_seen.push_back(line.seen());
  foot.points.resize(foot.directions.size());
  forEachIndex(foot.points.size(), 0, [&](std::size_t i) {
    const double direction = foot.directions[i];
    foot.points[i] = foot.ring.around(direction, foot.half_step, tank.foot(direction), reach);
  });
  return foot;
}

/// What the report shows of each station; an outlier's points are shown without the line that was refused.
std::vector<StationProfile> profilesOf(const Foot& foot, const FootElevations& elevations,
                                       const std::vector<FootFit>& fits, const std::vector<ShellLine>& shell,
                                       const ProfileBand& band) {
  std::vector<StationProfile> profiles;
  if (foot.options.profile_points == 0) return profiles;
  profiles.resize(fits.size());
  forEachIndex(profiles.size(), 0, [&](std::size_t i) {
    const ProfileWindow window{foot.directions[i], foot.half_step, elevations.filled[i], foot.reach, band};
    profiles[i] = profileOf(foot.ring, window, fits[i], shell[i], foot.options.profile_points);
  });
  return profiles;
}

/// Each station's fit of foundation and shell. Stations stand at their azimuths about the fitted centre, which is
/// millimetres from the one the fits went round: the shell moves by that in radius, and its elevation by nothing that
/// can be told.
std::vector<StationDatum> stationsOf(const Foot& foot, const std::vector<FootFit>& fits,
                                     const std::vector<ShellLine>& shell, const Eigen::Vector2d& from,
                                     const Eigen::Vector2d& to) {
  std::vector<StationDatum> stations(fits.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    StationDatum& s = stations[i];
    const FootFit& fit = fits[i];
    s.direction = foot.directions[i];
    s.n_shell = shell[i].points;
    s.n_foundation = fit.points;
    if (!fit.valid()) continue;
    const Eigen::Vector2d outwards(portable::cos(s.direction), portable::sin(s.direction));
    s.flag = StationFlag::Measured;
    s.z = fit.z;
    s.sigma_z = fit.sigma;
    s.window = 2.0 * fit.half_width;
    s.radius = shell[i].radius - outwards.dot(to - from);
    s.sigma_radius = shell[i].sigma_radius;
    s.x = to.x() + s.radius * outwards.x();
    s.y = to.y() + s.radius * outwards.y();
  }
  return stations;
}

/// The stations with the reasons why some are not measured; where no outlier was found it is for want of points.
std::vector<StationDatum> withReasons(std::vector<StationDatum> stations, const std::vector<Unmeasured>& outliers) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (stations[i].flag == StationFlag::Measured) continue;
    stations[i].reason = outliers[i] == Unmeasured::None ? Unmeasured::Hidden : outliers[i];
  }
  return stations;
}

/// The stations without a datum at which another wall stands, cladding on a part of the ring.
std::vector<StationDatum> withoutOtherWalls(std::vector<StationDatum> stations, const ShellFits& shell,
                                            const std::vector<bool>& strays, double arc) {
  if (strays.empty()) return stations;
  const std::vector<bool> other = findOtherWalls(shell.lines, strays, arc);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if ((other[i] || shell.clad[i]) && stations[i].flag == StationFlag::Missing)
      stations[i].reason = Unmeasured::OffCircle;
  }
  return stations;
}

/// The stations on what they lie above their fits by.
std::vector<StationDatum> onLips(std::vector<StationDatum> stations, const std::vector<Lift>& lifts) {
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].z += lifts[i].height;
    stations[i].sigma_z = std::hypot(stations[i].sigma_z, lifts[i].sigma);
  }
  return stations;
}

/// What belongs to the stations asked for, in their order, of what belongs to the fitted ones; of nothing, nothing.
template <typename T>
std::vector<T> asAsked(const std::vector<T>& all, const StationOptions& fitted, const StationOptions& asked) {
  std::vector<T> some;
  if (all.empty()) return some;
  for (const Station& s : emptyStations(asked)) {
    const double turns = turnAhead(fitted.zero_azimuth, s.direction) / kTwoPi;
    some.push_back(all[static_cast<std::size_t>(std::lround(turns * fitted.count)) % all.size()]);
  }
  return some;
}

}  // namespace

RefinedFoot refineStations(const Ring& ring, const Tank& tank, const RefineOptions& options,
                           const StationOptions& asked) {
  const StationOptions fitted = fittedStations(asked);
  RefinedFoot found;
  found.refined.circle = tank.circle;
  found.refined.rounding = ring.rounding;
  PolarRing polar(ring.points, tank.circle.center);
  const ShellFits shell = fitShellLines(directionsOf(fitted), polar, tank, ring.reach);
  if (!(shell.noise() > 0.0)) return found;  // no shell line anywhere
  const Foot foot = lookAtFoot(std::move(polar), shell, tank, options, fitted, ring.rounding);
  FootElevations elevations;
  const FootPass pass = runPasses(foot, tank, elevations);
  found.refined.profile = pass.sections.whole;
  if (found.refined.profile.unseen > 0.0) return found;
  FootLevels levels = isResolved(foot) ? levelStations(foot, pass) : FootLevels{pass.fits, {}};
  levels.fits = withCoverDoubted(std::move(levels.fits), pass.outliers.maybe_cover, foot);
  levels.fits = withLevelDoubted(std::move(levels.fits), pass.sections.other_level);
  levels.fits = withLevelDoubted(std::move(levels.fits), elevations.below_most);
  levels.fits = withFallDoubted(std::move(levels.fits), pass.sections, foot.reach);
  levels.fits = withPipeDoubted(std::move(levels.fits), pass.sections, foot.reach);
  found.refined.maybe_pipe = std::max(heightOfPipe(pass.sections.whole, foot.reach), elevations.below_most);
  found.refined.liquid = pass.liquid;
  found.refined.falls = pass.priors.falls() ? -pass.priors.seen : 0.0;
  found.refined.shell_from = shellSeenFrom(foot, levels.fits);
  found.refined.under_shell = pass.under_shell;
  found.refined.above_shell = shareAboveShell(foot, levels.fits);
  if (!pass.hasLiquid()) found.refined.raised = raisedAboveRest(foot, levels.fits);  // the floor under it is lower
  const ProfileBand band{found.refined.profile.band_to, signOf(tank.side)};
  std::vector<bool> stand;
  for (const FootFit& fit : levels.fits) stand.push_back(fit.valid());
  const ShellCircle round =
      fitShellCircle(shell.lines, foot.directions, shell.heights, tank.circle, priorOf(tank), stand);
  found.refined.circle = round.circle;
  found.refined.sigma_radius = round.sigma_radius;
  const auto stations = withReasons(stationsOf(foot, levels.fits, shell.lines, tank.circle.center, round.circle.center),
                                    pass.outliers.reasons);
  const double sigma_bend = kHighestWave / tank.circle.radius;
  auto bridged = withGapsBridged(stations, levels.process, foot, {round.circle, sigma_bend, fitted});
  if (isResolved(foot)) bridged = withShadowsDoubted(std::move(bridged), foot, pass);
  bridged = withRefusedDoubted(std::move(bridged), pass.outliers.refused, foot);
  bridged = withoutOtherWalls(std::move(bridged), shell, round.strays, foot.arc());
  const std::vector<Lift> lifts = findNarrowLips(foot, levels.fits, pass.sections);
  found.refined.narrow_lip = usualLip(lifts, levels.fits);
  if (found.refined.narrow_lip > 0.0) found.refined.profile.surface = Surface::AnnularPlate;
  found.stations = asAsked(onLips(std::move(bridged), lifts), fitted, asked);
  found.refined.sections = asAsked(profilesOf(foot, elevations, levels.fits, shell.lines, band), fitted, asked);
  return found;
}

}  // namespace tank_datum
