#pragma once

#include <limits>
#include <vector>

#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

/// The points of a fit, and the fit through them.
struct FittedPoints {
  std::vector<FootPoint> points;
  FootFit fit;
  double steepness =
      std::numeric_limits<double>::infinity();  ///< tangent of the rays' angle to the surface; 0: not known
};

/// How far a point lies above a fit [m].
double offOf(const FootPoint& p, const FootFit& fit);

/// Where the ray of a point would meet the fit that it lies so far off. A row of the scan meets bumps farther out, and
/// noise moves its points so: what lies together there is not chosen by its heights.
FootPoint metAt(const FootPoint& p, double off, const FittedPoints& fitted);

/// Whether a point that lies so far off a fit is one of the band's.
bool isOfBand(const FootPoint& p, double off, const FootFit& fit, const FootProfile& profile);

/// What two points of a stretch share on the average, of a process of the length.
double sharedAlong(double stretch, double length);

/// What a surface's roughness, which neighbouring points share, adds to the error of its level: from how far parts of
/// the band lie off the fits, beyond what points that err alone do (a variance component).
/// @param fits     all round; those of few points tell nothing
/// @return variance of a level over the points' own number times its formal variance: sigma^2 of a fit grows by this
///         times n (sigma / noise)^2 [m^2]
double sharedRoughness(const std::vector<FittedPoints>& fits, const FootProfile& profile);

/// A surface whose heights are a random process, alike over patches (correlated as exp(-x^2 / (2 length^2))).
struct Roughness {
  double heights = 0;  ///< root mean square, about the surface [m]
  double length = 0;   ///< [m]
  /// Root mean square, to any side [m/m].
  double slopes() const { return heights > 0.0 ? heights / length : 0.0; }
};

/// Roughness of the band: its heights from how points scatter, the length of its patches from what pairs of points
/// share whose rays would meet the fit in one cell. Fits whose rays are not known tell nothing.
/// @param fits   all round, each over several degrees
/// @param noise  what the points err by, each alone [m]
Roughness roughnessOf(const std::vector<FittedPoints>& fits, const FootProfile& profile, double noise);

}  // namespace tank_datum
