#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/statistics.h"
#include "foot/foot_banks.h"
#include "foot/foot_check.h"
#include "foot/foot_heaps.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "foot/foot_state.h"
#include "foot/grazed_arcs.h"
#include "foot/lip_cover.h"
#include "foot/own_level.h"
#include "foot/shell_below.h"
#include "foot/slanting_beams.h"
#include "foot/soil_fillets.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// How many points of the surface that was fitted at a station its own stretch has, and whether it lies between points
/// of it.
struct Support {
  std::size_t own = 0;
  bool between = false;
};

Support supportOf(const Foot& foot, std::size_t station, const FootPass& pass) {
  const double step = foot.arc(), azimuth = foot.directions[station];
  const FootFit& fit = pass.fits[station];
  const FootProfile& profile = pass.sections.at(station);
  Support support;
  if (!fit.valid()) return support;
  const double within = 4.0 * fit.noise;
  bool left = false, right = false;
  foot.ring.visitAround(azimuth, 2.0 * foot.half_step, fit.z, foot.reach, [&](const FootPoint& p) {
    if (p.d < profile.band_from || p.d > profile.band_to) return;
    if (std::abs(offOf(p, fit)) > within) return;
    support.own += std::abs(p.t) <= 0.5 * step;
    (p.t < 0.0 ? left : right) = true;
  });
  support.between = left && right;
  return support;
}

/// A station is supported by points of its own; where the scan is so coarse that a stretch may be empty by chance, also
/// by points within a step on either side.
std::vector<bool> findSupport(const Foot& foot, const FootPass& pass) {
  constexpr double kPlenty = 20.0;
  std::vector<Support> supports(foot.directions.size());
  forEachIndex(supports.size(), 0, [&](std::size_t i) { supports[i] = supportOf(foot, i, pass); });
  std::vector<double> counts;
  for (const Support& s : supports) {
    if (s.own > 0) counts.push_back(static_cast<double>(s.own));
  }
  const bool coarse = median(counts) < kPlenty;
  std::vector<bool> supported;
  for (const Support& s : supports) supported.push_back(s.own > 0 || (coarse && s.between));
  return supported;
}

/// Whether a surface falls outwards or rises as no foundation does at its shell, here or all round: a bank, or what
/// beams leave that graze a crown before it. Rising all round, water would stand against the shell, as it does on
/// floors.
bool isSteep(const Foot& foot, const FootFit& fit, const FootPriors& priors) {
  constexpr double kRises = 0.05;                    // all round [m/m]
  const bool is_known = priors.sigma_seen < kRises;  // of what is not, nothing says that it is a surface
  return std::abs(fit.slope) > FootPriors::kSteepestFoot + 3.0 * fit.sigma_slope || priors.falls() ||
         (!foot.inside && priors.seen > kRises + (is_known ? 3.0 * priors.sigma_seen : 0.0));
}

/// isGrazed() of what a station's window shows. Floors are seen from above them and may rise by as much as beams fall.
bool isGrazedAt(const Foot& foot, std::size_t station, const FootPass& pass) {
  const FootFit& fit = pass.fits[station];
  if (foot.inside || !risesOutwards(fit)) return false;  // which spares gathering the points
  const auto points = foot.ring.around(foot.directions[station], fit.half_width, fit.z, foot.reach);
  return isGrazed(points, pass.sections.at(station), fit, foot.reach);
}

/// What a station's own points say of the surface that was fitted there.
struct StationFindings {
  Unmeasured reason = Unmeasured::None;
  bool is_kerb = false;     ///< it stands before the shell, which goes on below it
  bool is_heap = false;     ///< it is soil
  bool is_no_foot = false;  ///< no foundation is so, whatever lies beside
  FootFit own;              ///< ownFit() of the station and its neighbours
};

/// Where a station shows what may be the foundation, if not where that was looked for.
RefusedLevel elsewhereAt(const Foot& foot, std::size_t station, const FootPass& pass) {
  const FootFit fit = fitAtOwnLevel(foot, station, pass);
  const bool is_no_foot = !fit.valid() || countShell(foot, station, fit).goOn() || isHeap(station, pass.priors, fit) ||
                          isSteep(foot, fit, pass.priors);
  return is_no_foot ? RefusedLevel{} : RefusedLevel{fit.z, fit.along};
}

StationFindings findingsAt(const Foot& foot, std::size_t station, const FootPass& pass, bool supported) {
  StationFindings found;
  const FootFit& fit = pass.fits[station];
  if (!foot.shell_seen[station]) {
    found.reason = Unmeasured::NoShell;
  } else if (!fit.valid() || !supported) {
    found.reason = Unmeasured::Hidden;
  } else {
    found.own = ownFit(foot, station, pass, kWithNeighbours * foot.half_step);
    found.is_kerb = countShell(foot, station, fit).goOn();
    found.is_heap = isHeap(station, pass.priors, found.own) || isHeapInHalf(foot, station, pass) ||
                    isHeapBefore(foot, station, pass);
    found.is_no_foot =
        found.is_kerb || found.is_heap || isSteep(foot, fit, pass.priors) || isGrazedAt(foot, station, pass);
    if (found.is_no_foot ||
        !isSameSurface(foot.points[station], fit, pass.priors.slope[station], pass.sections.at(station)))
      found.reason = Unmeasured::OtherSurface;
  }
  return found;
}

/// Whether the shell is seen, at the stations of a run, to go down to them from the level beside.
bool goesDownTo(const Foot& foot, const StepRun& run, const std::vector<FootFit>& fits) {
  ShellCounts shell;
  for (const std::size_t i : run.stations)
    shell.add(countShell(foot, i, levelAt(foot, run.beside, 0.0), run.beside - fits[i].z));
  return shell.goOn();
}

}  // namespace

std::vector<bool> stoodBefore(const FootElevations& elevations, const FootOutliers& before) {
  const std::vector<Unmeasured>& reasons = before.reasons;
  const bool tell = std::count(reasons.begin(), reasons.end(), Unmeasured::None) >
                    std::count(reasons.begin(), reasons.end(), Unmeasured::OtherSurface);
  std::vector<bool> stood;
  for (std::size_t i = 0; i < elevations.known.size(); ++i)
    stood.push_back(std::isfinite(elevations.known[i]) && (!tell || reasons[i] == Unmeasured::None));
  return stood;
}

std::vector<FootFit> standing(std::vector<FootFit> fits, const std::vector<Unmeasured>& reasons) {
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (reasons[i] != Unmeasured::None) fits[i] = {};
  }
  return fits;
}

FootOutliers findOutliers(const Foot& foot, const FootPass& pass) {
  const std::vector<bool> supported = findSupport(foot, pass);
  std::vector<Unmeasured> reasons(pass.fits.size(), Unmeasured::None);
  std::vector<char> kerbs(reasons.size(), 0), no_foot(reasons.size(), 0), heaps(reasons.size(), 0);
  std::vector<FootFit> own(reasons.size());
  forEachIndex(reasons.size(), 0, [&](std::size_t i) {
    StationFindings found = findingsAt(foot, i, pass, supported[i]);
    reasons[i] = found.reason;
    kerbs[i] = found.is_kerb, heaps[i] = found.is_heap, no_foot[i] = found.is_no_foot;
    own[i] = std::move(found.own);
  });
  const auto refuse = [&](const std::vector<bool>& found) {
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i]) no_foot[i] = 1, reasons[i] = Unmeasured::OtherSurface;
    }
  };
  const std::vector<bool> shell_below = findShellBelow(foot, standing(pass.fits, reasons));
  refuse(shell_below);
  for (std::size_t i = 0; i < kerbs.size(); ++i) {
    if (shell_below[i]) kerbs[i] = 1;
  }
  own = standing(std::move(own), reasons);
  const std::vector<bool> going_on = findHeapsGoingOn(foot, pass.priors, own, {heaps.begin(), heaps.end()});
  const std::vector<bool> heaped = findHeapedArcs(foot, pass.priors, own);
  const std::vector<FootFit> stand_so_far = standing(pass.fits, reasons);
  const std::vector<bool> grazed = findGrazedArcs(foot, pass, stand_so_far);
  LipCover cover = findLipCover(foot, pass, stand_so_far);
  const std::vector<bool> fillets = findFillets(foot, pass, stand_so_far);
  refuse(heaped);
  refuse(fillets);
  refuse(going_on);
  refuse(grazed);
  refuse(cover.covered);
  const auto stand = std::count(reasons.begin(), reasons.end(), Unmeasured::None);
  const auto kerb_stations = std::count(kerbs.begin(), kerbs.end(), 1);
  const bool none =
      static_cast<std::size_t>(stand) < kAsMany * static_cast<std::size_t>(kerb_stations) || areHeaps(own, pass.priors);
  const std::vector<FootFit> kept = standing(pass.fits, reasons);
  const std::vector<double> levels = elevationsOf(kept);
  const std::vector<bool> banks = findBanks(foot, pass.sections.whole, levels, pass.stood);
  const std::vector<bool> hanging = findHangingRuns(foot, pass.sections.whole, levels),
                          islands = findStrangeIslands(foot, pass.priors, own);
  Steps steps = findSteps(kept, foot.arc(), [&](const StepRun& run) { return goesDownTo(foot, run, kept); });
  std::vector<RefusedLevel> refused(reasons.size());
  forEachIndex(reasons.size(), 0, [&](std::size_t i) {
    if (reasons[i] == Unmeasured::None && (none || steps.dropped[i] || banks[i] || hanging[i] || islands[i]))
      reasons[i] = Unmeasured::OtherSurface;
    const bool may_be =
        reasons[i] == Unmeasured::OtherSurface && !none && no_foot[i] == 0 && !hanging[i] && !islands[i];
    if (!may_be && reasons[i] != Unmeasured::Hidden) return;
    refused[i] = elsewhereAt(foot, i, pass);
    if (may_be && !std::isfinite(refused[i].z)) refused[i] = {pass.fits[i].z, kUnknown};
  });
  const std::vector<bool> outnumbered = findOutnumberedIslands(reasons, foot.stationsIn(kFarIsland));
  for (std::size_t i = 0; i < reasons.size(); ++i) {
    if (!outnumbered[i]) continue;
    reasons[i] = Unmeasured::OtherSurface;
    refused[i] = {pass.fits[i].z, kUnknown};
  }
  if (foot.inside) {
    const std::vector<bool> lone = findLoneStations(reasons, foot.stationsIn(kFarIsland));
    for (std::size_t i = 0; i < reasons.size(); ++i) {
      if (lone[i]) reasons[i] = Unmeasured::Hidden;
    }
  }
  own = standing(std::move(own), reasons);
  return {std::move(reasons), std::move(steps.dips), std::move(refused), std::move(cover.maybe), std::move(own)};
}

std::vector<double> elevationsOf(const std::vector<FootFit>& fits) {
  std::vector<double> elevations;
  for (const FootFit& fit : fits) elevations.push_back(fit.z);
  return elevations;
}

std::vector<double> withoutOutliers(const std::vector<double>& elevations, const FootOutliers& outliers, bool narrow) {
  std::vector<double> kept = elevations;
  std::size_t known = 0, stand = 0, lie = 0;  // on something else
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool is_known = std::isfinite(elevations[i]);
    known += is_known;
    stand += is_known && outliers.reasons[i] == Unmeasured::None;
    lie += is_known && outliers.reasons[i] == Unmeasured::OtherSurface;
    if (outliers.reasons[i] != Unmeasured::None) kept[i] = kUnknown;
  }
  return 2 * stand > known || (narrow && lie > 0 && stand > lie) ? kept : elevations;
}

}  // namespace tank_datum
