#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "fit/adaptive_smooth.h"
#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

// A laser beam has a width, and its range is a mean over its footprint. Where it slants to the foundation and its
// footprint reaches the shell, the point is lifted, the more the nearer it lies to the shell: a lip that is level seems
// to lean, and its middle is lifted.

/// Whether a point is of the part of the shell above the foot whose points tell how steeply rays come.
bool isOnShell(const FootPoint& p, const FootProfile& profile, double level, double reach);

/// How steeply a surface is seen that has so many points a metre outwards, beside so many on the shell.
/// @param on_shell  as isOnShell() says
/// @return nothing where these are too few to tell
std::optional<double> steepnessBy(double points_a_metre, double on_shell, double reach);

/// How steeply the foot is seen: tan of the rays' angle to the foundation. Of equal areas of foundation and shell the
/// one across which the rays slant gets fewer points.
/// @param points  of a window, shell and foundation
/// @param level   of the foundation [m]
/// @param reach   of the section [m]
/// @return 0, as if they grazed, where the shell shows too few points to tell
double steepnessOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach);

/// Points of a window on the foundation and on the shell.
struct RayCounts {
  double on_band = 0;   ///< points on the foundation
  double a_metre = 0;   ///< of those to a metre outwards [1/m]
  double on_shell = 0;  ///< points on the shell, up to a height that all windows have alike

  double beyond = 0;   ///< points a metre outwards where no beam meets a lip's edge too [1/m]
  double wide = 0;     ///< points of a wide surface, as far as it is seen to go on
  double wide_to = 0;  ///< how far that is from the shell [m]

  void add(const RayCounts& o) {
    on_band += o.on_band, a_metre += o.a_metre, on_shell += o.on_shell, wide += o.wide,
        wide_to = std::max(wide_to, o.wide_to), beyond += o.beyond;
  }
  /// What they show, as steepnessOf().
  double steepness(double reach) const;
};

/// @param points,profile,level,reach  as of steepnessOf()
RayCounts countRays(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach);

/// Steepness at windows round the ring, each with as many beside it as together have points of a few rows.
/// @param reach  of the section [m]
std::vector<double> pooledSteepness(const std::vector<RayCounts>& windows, double reach);

/// Steepness at windows round the ring. Where few rows of the scan cross a lip, a window that shows some of it has more
/// points than its share, as if rays were steep: it is seen no more steeply than with those beside it together, until
/// there are enough points.
/// @param steepness  pooledSteepness() of them
/// @param reach      of the section [m]
std::vector<double> steepnessAlong(const std::vector<RayCounts>& windows, std::vector<double> steepness, double reach);

/// Steepness of a whole ring's rays. Beams that meet a lip's weld or edge too fill the lip with points, as if rays were
/// steep; they do not where what it lies on is seen farther out: the one with fewer points counts.
double ringSteepness(const std::vector<RayCounts>& windows, double reach);

/// The most that a lip may seem to lean where beams slant: the slope that a beam's width is over the lip, less the
/// slope of the rays; as measured on simulated lips that are level. Zero where the footprint is shorter than the lip.
/// @param lip  width of the lip [m]
/// @return [m/m]
double beamLean(double steepness, double lip);

/// The same of a whole ring's lips, whose slope is known so well that what beams feign at a lip's two ends counts
/// though their footprint is shorter than the lip; as measured on simulated lips that are level.
/// @param lip           as of beamLean, wider than the largest weld
/// @param largest_weld  to expect [m]
double ringBeamLean(double steepness, double lip, double largest_weld);

/// Whether a surface rises outwards by more than its error explains; no other can be grazed.
bool risesOutwards(const FootFit& fit);

/// Whether a surface is none but the line along which beams that graze an edge farther out reach the shell, with points
/// between the two by beams that meet both: it rises outwards at a good part of the beams' own slope, towards something
/// higher. A surface that rises so would hardly be seen.
/// @param points  of a window, about the fit's elevation
bool isGrazed(const std::vector<FootPoint>& points, const FootProfile& profile, const FootFit& fit, double reach);

/// How the points of a band lie across it; sums of many windows.
struct BandPoints {
  double squares = 0;   ///< of distances from their window's mean [m^2]
  double short_of = 0;  ///< points fewer than even ones would be that are as dense as these at the band's ends
  double variance = 0;  ///< of that, by chance

  void add(const BandPoints& o) { squares += o.squares, short_of += o.short_of, variance += o.variance; }
};

/// @param points,level  as of steepnessOf()
BandPoints bandPointsOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level);

/// The slope that range noise feigns: it moves points along their rays, in distance and height together, and so draws a
/// band's slope to that of the rays where the points are denser in its middle than at its ends. The mean displacement
/// of points at a distance is minus the noise's variance times the logarithmic derivative of their density (Tweedie's
/// formula); the slope is its regression.
/// @param noise    of the distance from the shell [m]
/// @param scatter  of heights about the surface, the most that the noise moves them by [m]
/// @return the slope and its standard error, together [m/m]
double feignedSlope(const BandPoints& points, double steepness, double noise, double scatter);

/// The slope that beams may feign on a lip: as what is lifted beyond its edge shows, or its unevenness hides.
/// @param most  that they can, as they slant; what is lifted for sure counts nevertheless [m/m]
/// @return [m/m]
double blendLean(const FootProfile& profile, double most);

/// The most that a lip may seem to rise before a crown: beams that meet the crown's edge too leave points on the line
/// from the lip's end to there, and lift the lip's, the more the nearer its end. Zero where what lies just beyond what
/// is seen of the lip is lower, or hidden.
/// @return [m/m]
double crownRise(const FootProfile& lip);

/// The slope that beams feign which meet shell or edge too, where a lip is seen to lean otherwise than it does: no more
/// than they can, and downwards only.
/// @param seen  with the standard error of what is seen
/// @param lip   its own slope [m/m]
/// @param lean  beamLean there
SeriesValue blendedSlope(const SeriesValue& seen, double lip, double lean);

/// How far a lip's middle may be lifted where it is seen to lean otherwise than it does, as a slope that would do it
/// about the shell.
/// @param seen,lip  slopes [m/m]; 0 where one is not known
/// @param lean      beamLean there
double liftOf(double seen, double lip, double lean);

}  // namespace tank_datum
