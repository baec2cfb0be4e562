#include "foot/foot_bridges.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/ring_runs.h"
#include "foot/shell_below.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

/// The straight line across a gap between the stations beside it [m].
double lineAcross(const RingRun& gap, const std::vector<StationDatum>& stations, std::size_t k) {
  const std::size_t count = stations.size();
  const double share = static_cast<double>(k + 1 - gap.first) / static_cast<double>(gap.last + 2 - gap.first);
  return (1.0 - share) * stations[(gap.first + count - 1) % count].z + share * stations[(gap.last + 1) % count].z;
}

/// Bridges a gap along the process. Where a station beside it lies off that, as in a dip, straight from side to side,
/// with a sigma that holds both.
void bridgeAlong(const RingProcess& process, const RingRun& gap, std::vector<StationDatum>& stations) {
  const std::size_t count = stations.size(), before = (gap.first + count - 1) % count, after = (gap.last + 1) % count;
  const StationDatum a = stations[before], b = stations[after];
  const bool along = process.holds(a.z, a.sigma_z, before) && process.holds(b.z, b.sigma_z, after);
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    StationDatum& s = stations[k % count];
    const double expected = process.value[k % count], sigma = std::max(s.sigma_z, process.sigma[k % count]);
    const double line = lineAcross(gap, stations, k);
    s.z = along ? expected : line;
    s.sigma_z = along ? sigma : std::hypot(sigma, kEither * (line - expected));
  }
}

/// Lets no bridge be surer further in than it is on both sides: the process may have ended in between.
void doubtInwards(const RingRun& gap, std::vector<StationDatum>& stations) {
  std::vector<double> from_end(gap.last - gap.first + 1);
  double most = 0.0;
  for (std::size_t k = gap.last + 1; k-- > gap.first;) {
    most = std::max(most, stations[k % stations.size()].sigma_z);
    from_end[k - gap.first] = most;
  }
  most = 0.0;
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    double& sigma = stations[k % stations.size()].sigma_z;
    most = std::max(most, sigma);
    sigma = std::min(most, from_end[k - gap.first]);
  }
}

/// The stations with the short gaps among them bridged.
std::vector<StationDatum> bridged(std::vector<StationDatum> stations, const RingProcess& process,
                                  const BridgeScales& scales) {
  std::vector<bool> measured;
  for (const StationDatum& s : stations) measured.push_back(s.flag == StationFlag::Measured);
  const std::vector<StationFlag> flags = flagsOf(measured, scales.stations);
  std::vector<char> gaps;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].flag = flags[i];
    gaps.push_back(flags[i] == StationFlag::Interpolated ? 1 : 0);
  }
  stations = bridgeGaps(stations, scales.circle.center, scales.sigma_bend);
  if (!process.valid()) return stations;
  for (const RingRun& gap : runsRound(gaps)) {
    bridgeAlong(process, gap, stations);
    doubtInwards(gap, stations);
  }
  return stations;
}

/// The level that a gap's bridge has at its stations, or the lower of a line across it and what the others say of it:
/// a process goes astray in a long one, as it rises from both sides.
/// @return  not valid at stations that are measured, and where nothing is expected
std::vector<FootFit> levelsInGaps(const Foot& foot, const std::vector<RingRun>& gaps,
                                  const std::vector<StationDatum>& stations, const RingProcess& expected) {
  std::vector<FootFit> levels(stations.size());
  for (const RingRun& gap : gaps) {
    for (std::size_t k = gap.first; k <= gap.last; ++k) {
      const std::size_t i = k % stations.size();
      const StationDatum& s = stations[i];
      if (s.flag == StationFlag::Interpolated) {
        levels[i] = levelAt(foot, s.z, s.sigma_z);
      } else if (expected.valid()) {
        const double line = lineAcross(gap, stations, k), value = expected.value[i];
        levels[i] = levelAt(foot, std::min(line, value), std::hypot(expected.sigma[i], kEither * (value - line)));
      }
    }
  }
  return levels;
}

/// The shell about such levels.
std::vector<ShellCounts> shellAbout(const Foot& foot, const std::vector<FootFit>& levels) {
  std::vector<ShellCounts> counts(levels.size());
  forEachIndex(levels.size(), 0, [&](std::size_t i) {
    if (levels[i].valid() && foot.shell_seen[i]) counts[i] = countShell(foot, i, levels[i]);
  });
  return counts;
}

/// Whether the shell goes on below at three neighbours of a gap together.
bool goesOnIn(const RingRun& gap, const std::vector<ShellCounts>& counts) {
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    ShellCounts three;
    for (std::size_t n = std::max(gap.first, k - std::min<std::size_t>(k, 1)); n <= std::min(gap.last, k + 1); ++n)
      three.add(counts[n % counts.size()]);
    if (three.goOn()) return true;
  }
  return false;
}

/// A station of which only its points are known.
StationDatum unknown(const StationDatum& station, Unmeasured reason) {
  StationDatum missing;
  missing.direction = station.direction;
  missing.n_shell = station.n_shell;
  missing.n_foundation = station.n_foundation;
  missing.reason = reason;
  return missing;
}

/// A gap below whose bridge the shell goes on, with the stations beside it at which some of the shell is seen below
/// too: a few points, as there is a reason beside.
RingRun withBeside(RingRun gap, const Foot& foot, const std::vector<StationDatum>& stations) {
  const std::size_t count = stations.size();
  const auto lies_lower = [&](std::size_t i) {
    const StationDatum& s = stations[i % count];
    return s.flag == StationFlag::Measured && countShell(foot, i % count, levelAt(foot, s.z, s.sigma_z)).isGoodPart();
  };
  gap.first += count, gap.last += count;
  while (gap.last - gap.first < count - 2 && lies_lower(gap.last + 1)) ++gap.last;
  while (gap.last - gap.first < count - 2 && lies_lower(gap.first - 1)) --gap.first;
  return gap;
}

/// The stations without a datum in gaps where the shell is seen to go on below: the datum lies lower there, by what is
/// not known. Where that is a third of all, what the others lie on is not the foot either.
/// @param expected  elevation and its standard error at every station, as the others say
std::vector<StationDatum> withoutGapsAboveShell(std::vector<StationDatum> stations, const Foot& foot,
                                                const RingProcess& expected) {
  std::vector<char> gap;
  for (const StationDatum& s : stations) gap.push_back(s.flag == StationFlag::Measured ? 0 : 1);
  const std::vector<RingRun> gaps = runsRound(gap);
  const std::vector<ShellCounts> counts = shellAbout(foot, levelsInGaps(foot, gaps, stations, expected));
  std::size_t below = 0;
  for (const RingRun& run : gaps) {
    if (!goesOnIn(run, counts)) continue;
    const RingRun all = withBeside(run, foot, stations);
    for (std::size_t k = all.first; k <= all.last; ++k) {
      StationDatum& s = stations[k % stations.size()];
      s = unknown(s, s.reason == Unmeasured::NoShell ? s.reason : Unmeasured::ShellBelow);
      below += s.reason == Unmeasured::ShellBelow ? 1 : 0;
    }
  }
  const auto measured = static_cast<std::size_t>(std::count(gap.begin(), gap.end(), 0));
  if (measured >= kAsMany * below) return stations;
  for (StationDatum& s : stations) s = unknown(s, s.reason == Unmeasured::None ? Unmeasured::OtherSurface : s.reason);
  return stations;
}

}  // namespace

std::vector<StationDatum> withGapsBridged(const std::vector<StationDatum>& stations, const RingProcess& process,
                                          const Foot& foot, const BridgeScales& scales) {
  return withoutGapsAboveShell(bridged(stations, process, scales), foot, process);
}

}  // namespace tank_datum
