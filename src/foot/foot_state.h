#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit/ring_process.h"
#include "foot/foot_fit.h"
#include "foot/foot_profile.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

constexpr double kSettledSlope = 1e-4;          ///< standard deviation of a slope that is not to be learnt again [m/m]
constexpr double kSlopeWindow = 5.0 * kDegree;  ///< in which the slope of a lip is looked at [rad]
constexpr double kFarIsland = 10.0 * kDegree;   ///< over which no gap between stations is bridged [rad]
constexpr double kHolds = 0.5;                  ///< of a difference: two standard errors hold it
constexpr double kDip = 0.01;        ///< of the reach: what a datum does locally, on a ring that is quiet elsewhere
constexpr double kHeapFalls = 0.01;  ///< than a wide surface does all round: what falls by more is no foundation [m/m]

/// What the passes look at; none of them changes it. Vectors are indexed by station.
struct Foot {
  FootRing ring;
  RefineOptions options;
  FootScales scales;
  double reach;                                ///< of the ring [m]
  double half_step;                            ///< half the angle between stations [rad]
  double radius;                               ///< of the shell, roughly [m]
  double rounding;                             ///< step that elevations were rounded to, or 0 [m]
  std::vector<double> directions;              ///< counter-clockwise at equal steps [rad]
  std::vector<std::vector<FootPoint>> points;  ///< of each station's own stretch
  std::vector<bool> shell_seen;                ///< whether the shell is seen at the station itself
  bool inside = false;                         ///< a floor is seen inside the shell, which may rise away from it

  /// Arc between stations [m].
  double arc() const { return 2.0 * half_step * radius; }
  /// How many stations an angle holds, one at least.
  /// @param angle  [rad]
  std::size_t stationsIn(double angle) const {
    return static_cast<std::size_t>(std::max(1.0, std::round(0.5 * angle / half_step)));
  }
  /// How many an angle holds to either side of a station, each of them once.
  std::size_t stationsBeside(double angle) const { return std::min(stationsIn(angle), (directions.size() - 1) / 2); }
};

/// The elevations that a pass begins with.
struct FootElevations {
  std::vector<double> known;   ///< to stack the section with; NaN where a station is to be left out [m]
  std::vector<double> filled;  ///< as known so far, filled up in gaps [m]
  std::vector<bool> seen;      ///< a surface that the shell may stand on was seen here or close by
  double below_most = 0;       ///< how far below what most stations show, which may be a cable upon it; else 0 [m]
};

/// Whether the scan is quiet enough to tell surfaces at different heights apart. Where it is not, as on tins on a table
/// seen by a depth camera, each station goes by its own points.
bool isResolved(const Foot& foot);

/// A first elevation of each station, from the stretch that the shell stands on: chosen for the whole ring together, so
/// that a bank over two thirds of the foot does not pass for it. Sparse stations look a few degrees around.
/// @param tank  whose coarse foot the points are looked for around
/// @param left_out  stations that are not looked at
FootElevations firstElevations(const Foot& foot, const Tank& tank, const std::vector<bool>& left_out = {});

/// Stations whose elevation is known, and those within a few degrees of one.
/// @param elevations  NaN where not known [m]
std::vector<bool> closeTo(const Foot& foot, const std::vector<double>& elevations);

/// The section of the foot, stacked over the whole ring and over arcs of it.
struct FootSections {
  FootProfile whole;
  std::vector<FootProfile> arcs;  ///< at equal steps from the first station on; empty: the whole one everywhere
  std::size_t stations = 0;
  double other_level = 0;  ///< how far off these the surface lay that a later pass showed, as heldTo() says [m]

  const FootProfile& at(std::size_t station) const;
};

/// Stacks the stations' points relative to their elevation, NaN where a station is to be left out. Where the surface
/// ends near the shell, arcs are stacked too: an edge that does not follow the shell's lobes is sharp in a few degrees
/// only.
FootSections stackSections(const Foot& foot, const std::vector<double>& elevations);

/// The same of stations that stand, or of all that were fitted where those are too few to show a surface.
/// @param known   elevations of those that stand, else NaN [m]
/// @param fitted  of all; none where they do not count [m]
FootSections stackKnown(const Foot& foot, const std::vector<double>& known, const std::vector<double>& fitted);

/// Whether a section shows the surface that the elevations it was stacked with lie on.
bool isOfLevel(const FootProfile& section, double reach);

/// The sections that a pass goes by: its own, or those of the pass before where its own show another surface. What lies
/// lower than a lip is what it lies on, and no doubt of its level.
/// @param now,before  stacked with the elevations that were fitted to `before`, and with those before
FootSections heldTo(const FootSections& before, FootSections now, double reach);

/// First elevations that disagree among themselves blur the surfaces of a section, which then is of none of them. Where
/// it is so, each station is moved to where its own points lie on the section of all; else none is.
FootElevations alignedElevations(const Foot& foot, FootElevations elevations);

/// What beams that meet the shell or the edge too make of a lip: beside the shell they lift its points, beside the edge
/// they lower them, which feigns a slope. In between is a place where neither does.
struct BlendedLip {
  std::vector<double> slope, sigma;  ///< that is feigned at each station, and its standard error; empty: none [m/m]
  double level_at = 0;               ///< distance of that place from the shell [m]

  /// A fit without what blends do to it. Points that lie on either side of that place alike are off by nothing; the few
  /// rows of a scan that slants lie beside the shell here, beside the edge there.
  FootFit without(FootFit fit, std::size_t station) const;
};

/// What is known of the surface's slope at every station before its own points are looked at.
struct FootPriors {
  static constexpr double kSteepestFoot = 0.15;  ///< shoulders fall more steeply, but not at the shell [m/m]

  std::vector<double> slope, sigma_slope;  ///< [m/m]
  double feigned = 0;     ///< standard error that slopes of a wide surface have in common: by single rows [m/m]
  double lifted = 0;      ///< and by beams that meet the shell too [m/m]
  double sigma_bend = 0;  ///< of the datum's second-order term along the shell [1/m]
  bool settled = false;   ///< a station's own points have no more to say about its slope
  double seen = 0;        ///< as the ring's windows show it, feigned or not [m/m]
  double sigma_seen = 0;  ///< its standard error [m/m]
  double uneven = 0;      ///< what slopes of a lip's windows differ by beyond their errors [m/m]
  BlendedLip blends;      ///< where it is settled
  double scatter = 0;     ///< of points about a wide surface [m]
  Rounding rounding;      ///< of elevations [m]
  std::vector<BeamEffects> beams;  ///< at stations upon a wide surface; empty: none
  std::vector<double> steepness;   ///< how rays slant to a narrow one, at every station; 0: not known

  FootPrior at(std::size_t station) const;
  /// Whether the surface falls from the shell, all round, as no foundation does.
  bool falls() const { return seen < -kSteepestFoot; }
  /// Tangent of the rays' angle to the surface; without limit, as if they were plumb, where it is not known.
  double steepnessAt(std::size_t station) const;
};

/// The slope of a wide surface from the whole ring, that of a narrow one from arcs, each with what it leaves open.
FootPriors learnPriors(const Foot& foot, const FootElevations& elevations, const FootSections& sections);

/// The fit of one station. Windows grow by borrowing from the neighbours until the standard error is what was asked
/// for: that of the level, since the neighbours' points say no more about the slope than the prior does.
/// @param level  what is known of its elevation [m]
FootFit fitStation(const Foot& foot, std::size_t station, double level, const FootProfile& profile,
                   const FootPriors& priors);

/// A level that was refused and may be the datum nevertheless.
struct RefusedLevel {
  double z = kUnknown;      ///< [m]
  double along = kUnknown;  ///< how it is seen to rise along the shell [m/m]
};

/// Which fits of a pass do not stand.
struct FootOutliers {
  std::vector<Unmeasured> reasons;    ///< of each station; None: it stands
  std::vector<bool> dips;             ///< stations that stand, below those beside them by a step
  std::vector<RefusedLevel> refused;  ///< of those that may be the datum nevertheless
  std::vector<double> maybe_cover;    ///< how thick something may be that covers the foot where they stand [m]
  std::vector<FootFit> own;           ///< ownFit() of them and their neighbours, where they stand
};

/// What one pass found.
struct FootPass {
  FootSections sections;
  std::vector<bool> stood;  ///< before it: stations whose elevation was known and not left out
  FootPriors priors;
  std::vector<FootFit> fits;
  FootOutliers outliers;
  double under_shell = kUnknown;  ///< share of the stations under whose wall the foundation goes on, if not a few
  double liquid = 0;              ///< share of the stations upon what lies as liquid does

  /// Whether some lie on it, which are left out; where all do, none is.
  bool hasLiquid() const { return liquid > 0.0 && liquid < 1.0; }
};

/// The stations' elevations as the ring's own covariance lets neighbours help.
struct FootLevels {
  std::vector<FootFit> fits;  ///< stations whose stretch shows no point of the surface are not valid
  RingProcess process;        ///< not valid where too few were fitted; else the sigmas hold what stations share [m]
};

/// Each stretch's own fit, then what they follow all together.
FootLevels levelStations(const Foot& foot, const FootPass& pass);

/// Why stations do not stand: their fit has no support of its own, lies on something else, or steps off its neighbours.
FootOutliers findOutliers(const Foot& foot, const FootPass& pass);

/// Stations that stood in the pass before, where these are more than those that lay on something else; else all that a
/// pass begins with.
std::vector<bool> stoodBefore(const FootElevations& elevations, const FootOutliers& before);

/// The fits without those of stations that do not stand.
std::vector<FootFit> standing(std::vector<FootFit> fits, const std::vector<Unmeasured>& reasons);

/// Elevations of fits; NaN where one is not valid [m].
std::vector<double> elevationsOf(const std::vector<FootFit>& fits);

/// Elevations to stack the next section with: without outliers, unless they are most of what there is. Stations that
/// show no point of their own say nothing against those that stand on a lip where others are seen to lie on something
/// else; on a wide surface these may lie on it, where its slope is another.
std::vector<double> withoutOutliers(const std::vector<double>& elevations, const FootOutliers& outliers, bool narrow);

}  // namespace tank_datum
