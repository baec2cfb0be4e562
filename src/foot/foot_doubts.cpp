#include "foot/foot_doubts.h"

#include <algorithm>
#include <cmath>

#include "core/ring_runs.h"
#include "core/units.h"
#include "foot/ring_slope.h"
#include "foot/section_end.h"

namespace tank_datum {
namespace {

/// What was refused in a gap, straight on from one station to the next and from those beside: the datum, if it is that.
class RefusedLine {
 public:
  /// @param arc  between stations [m]
  RefusedLine(const RingRun& gap, const std::vector<StationDatum>& stations, const std::vector<RefusedLevel>& refused,
              double arc)
      : arc_(arc) {
    const std::size_t count = stations.size();
    knots_.push_back({0, stations[(gap.first + count - 1) % count].z, 0.0});
    for (std::size_t k = gap.first; k <= gap.last; ++k) {
      const RefusedLevel& level = refused[k % count];
      if (std::isfinite(level.z)) knots_.push_back({k - gap.first + 1, level.z, level.along});
    }
    knots_.push_back({gap.last - gap.first + 2, stations[(gap.last + 1) % count].z, 0.0});
  }

  /// Whether a shell could follow it; not where nothing was refused.
  bool canBeDatum() const {
    constexpr double kSteepest = 0.2;  // a hundred times what the codes allow [m/m]
    constexpr double kUnseen = 0.1;    // beyond what the stations themselves rise by: else it is a step [m/m]
    const bool dips = this->dips();    // no soil lies lower than the stations beside a gap
    const auto lengthOf = [&](const Knot& from, const Knot& to) { return static_cast<double>(to.at - from.at) * arc_; };
    const Knot* known = &knots_.front();  // the last one that shows how it rises
    for (std::size_t i = 1; i < knots_.size(); ++i) {
      const Knot &before = knots_[i - 1], &here = knots_[i];
      if (std::abs(here.z - before.z) > kSteepest * lengthOf(before, here)) return false;
      if (dips || !std::isfinite(here.along)) continue;
      const double length = lengthOf(*known, here), seen = 0.5 * (known->along + here.along) * length;
      if (std::abs(here.z - known->z - seen) > kUnseen * length) return false;
      known = &here;
    }
    return knots_.size() > 2;
  }

  /// Whether all that was refused lies below the stations beside.
  bool dips() const {
    const double beside = std::min(knots_.front().z, knots_.back().z);
    return std::all_of(knots_.begin() + 1, knots_.end() - 1, [beside](const Knot& k) { return k.z < beside; });
  }

  /// Elevation so many stations on from the one before the gap [m].
  double at(std::size_t station) const {
    const auto after =
        std::find_if(knots_.begin() + 1, knots_.end() - 1, [&](const Knot& k) { return k.at >= station; });
    const Knot &a = *(after - 1), &b = *after;
    return a.z + (b.z - a.z) * static_cast<double>(station - a.at) / static_cast<double>(b.at - a.at);
  }

 private:
  struct Knot {
    std::size_t at;  ///< stations on from the one before the gap
    double z;        ///< [m]
    double along;    ///< as its station shows it, if it does [m/m]
  };
  double arc_;
  std::vector<Knot> knots_;
};

}  // namespace

std::vector<StationDatum> withRefusedDoubted(std::vector<StationDatum> stations,
                                             const std::vector<RefusedLevel>& refused, const Foot& foot) {
  constexpr double kBeside = 0.5;  // of the difference, where a dip begins at the station beside
  const std::size_t count = stations.size();
  std::vector<char> gaps;
  for (const StationDatum& s : stations) gaps.push_back(s.flag == StationFlag::Measured ? 0 : 1);
  if (std::count(gaps.begin(), gaps.end(), 0) == 0) return stations;
  for (const RingRun& gap : runsRound(gaps)) {
    const RefusedLine line(gap, stations, refused, foot.arc());
    if (!line.canBeDatum()) continue;
    for (std::size_t k = gap.first; k <= gap.last; ++k) {
      StationDatum& s = stations[k % count];
      s.z_refused = line.at(k - gap.first + 1);
      if (s.flag == StationFlag::Interpolated) s.sigma_z = std::hypot(s.sigma_z, kHolds * (s.z_refused - s.z));
    }
    if (!line.dips()) continue;
    const auto doubtBeside = [&](StationDatum& s, double next) {
      s.sigma_z = std::hypot(s.sigma_z, kHolds * kBeside * (s.z - next));
    };
    doubtBeside(stations[(gap.first + count - 1) % count], line.at(1));
    doubtBeside(stations[(gap.last + 1) % count], line.at(gap.last - gap.first + 1));
  }
  return stations;
}

std::vector<FootFit> withCoverDoubted(std::vector<FootFit> fits, const std::vector<double>& cover, const Foot& foot) {
  constexpr double kFades = 8.0 * kDegree;  // to either side of an arc: over which it may fade out
  const std::size_t count = cover.size(), fades = foot.stationsIn(kFades);
  std::vector<char> covered;
  for (const double thick : cover) covered.push_back(thick > 0.0 ? 1 : 0);
  for (const RingRun& run : runsRound(covered)) {
    std::size_t before = fades, after = fades;  // stations off the run
    const auto at = [&](std::size_t i) { return fits[i % count]; };
    while (before < count && !at(run.first + count - before).valid()) ++before;
    while (after < count && !at(run.last + after).valid()) ++after;
    const FootFit a = at(run.first + count - before), b = at(run.last + after);
    const bool beside = before < count && after < count;
    const auto length = static_cast<double>(run.last - run.first + before + after);
    for (std::size_t k = run.first; k <= run.last; ++k) {
      FootFit& fit = fits[k % count];
      const double along = static_cast<double>(k - run.first + before) / length;
      const double rise = fit.z - a.z - along * (b.z - a.z), thick = cover[k % count];
      fit.sigma = std::hypot(fit.sigma, kHolds * (beside ? std::clamp(rise, 0.0, thick) : thick));
    }
  }
  return fits;
}

std::vector<FootFit> withLevelDoubted(std::vector<FootFit> fits, double other) {
  for (FootFit& fit : fits) fit.sigma = std::hypot(fit.sigma, kHolds * other);
  return fits;
}

std::vector<FootFit> withFallDoubted(std::vector<FootFit> fits, const FootSections& sections, double reach) {
  constexpr double kNarrow = 0.5;  // of the reach
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (sections.at(i).edge > kNarrow * reach) continue;
    const double steeper = std::max(0.0, -fits[i].slope - kLipSlope);
    fits[i].sigma = std::hypot(fits[i].sigma, steeper * fits[i].middle);
  }
  return fits;
}

std::vector<FootFit> withPipeDoubted(std::vector<FootFit> fits, const FootSections& sections, double reach) {
  for (std::size_t i = 0; i < fits.size(); ++i)
    fits[i].sigma = std::hypot(fits[i].sigma, kHolds * heightOfPipe(sections.at(i), reach));
  return fits;
}

}  // namespace tank_datum
