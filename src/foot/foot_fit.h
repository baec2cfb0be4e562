#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/rounding_step.h"
#include "core/units.h"
#include "foot/beam_effects.h"
#include "foot/foot_profile.h"
#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "tank_datum/core/default_init_allocator.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

struct Tank;

constexpr double kSlopeVaries = 0.03;  ///< by less than this a foundation's slope does along the shell [m/m]

/// What is known of the foundation surface before a station's own points are looked at.
struct FootPrior {
  double slope = 0;        ///< across the shell [m/m]
  double sigma_slope = 0;  ///< how far stations differ from it [m/m]
  double sigma_bend = 0;   ///< of the datum's second-order term along the shell [1/m]
  double shared = 0;       ///< variance that the points' errors have in common, the surface's own roughness [m^2]
  double scatter = 0;      ///< of points about the surface where many rows show it: one row of a scan hides it [m]
  Rounding rounding;       ///< of elevations [m]
  BeamEffects beams;

  void take(const BeamEffects& effects) {
    beams = effects;
    scatter = std::max(scatter, effects.scatter);
  }
};

/// How far a fit may be off because beams that meet the shell too lift its points.
struct LiftedFit {
  double z = 0, slope = 0;  ///< [m], [m/m]
};

/// The foundation surface at one station: z at the shell, with its slope outwards.
struct FootFit {
  double z = kUnknown, sigma = kUnknown;            ///< at the shell, and its standard error [m]
  double slope = kUnknown, sigma_slope = kUnknown;  ///< [m/m]
  double along = kUnknown, bend = kUnknown;         ///< of z along the shell: along t + bend t^2 [m/m], [1/m]
  double middle = kUnknown;                         ///< mean distance of the points from the shell [m]
  double noise = kUnknown;                          ///< standard deviation of the points about it [m]
  double own = kUnknown;                            ///< the same of these points alone [m]
  double row = kUnknown;                            ///< share by which they are one row of a scan, 0 to 1
  LiftedFit lifted;                                 ///< in the standard errors too
  double rounding = 0;                              ///< standard error that rounding leaves in z, in sigma too [m]
  double half_width = kUnknown;                     ///< half the angle of the window the points come from [rad]
  std::size_t points = 0;                           ///< within the band of the profile

  bool valid() const { return sigma > 0.0; }
  /// The standard error that more points lessen: without what beams do to all of them [m].
  double sigmaOfPoints() const {
    const double left = (sigma - lifted.z) * (sigma + lifted.z);
    return left < 0.0 ? 0.0 : std::sqrt(left);  // NaN where there is none
  }
};

/// The ring's points as the foot sees them: arc along the shell, distance from it, elevation; in order of azimuth.
class FootRing {
 public:
  /// @param ring  taken over, so that its points are not held twice
  /// @param side  +1 when the foundation lies outside of the shell, -1 inside
  FootRing(PolarRing ring, const ShellModel& shell, double side, double reach);

  /// Leaves out what stands upright before the shell, as chairs and plants do, with the ground about its foot: points
  /// low on an upright face are near the foundation's level, and on one side of it.
  /// @param nearest  where the foundation begins [m]
  void leaveOutUprights(const Tank& tank, double nearest, double reach);

  /// The points within half_width [rad] of an azimuth and within `height` of an elevation [m].
  std::vector<FootPoint> around(double azimuth, double half_width, double z, double height) const;

  /// Calls visit(point) for each of them.
  template <typename Visit>
  void visitAround(double azimuth, double half_width, double z, double height, Visit&& visit) const {
    visitIn(azimuth, half_width, z, height, [&](const FootPoint& p) {
      if (p.d > behind_) visit(p);
    });
  }

  /// The same of those farther behind the shell than its noise and what stands against it reach.
  template <typename Visit>
  void visitBehind(double azimuth, double half_width, double z, double height, Visit&& visit) const {
    visitIn(azimuth, half_width, z, height, [&](const FootPoint& p) {
      if (p.d <= behind_) visit(p);
    });
  }

 private:
  struct Entry {
    double azimuth, radius, d, z;
  };
  using Entries = std::vector<Entry, DefaultInitAllocator<Entry>>;

  /// Indices of the first entry from an azimuth on, and of the first beyond another.
  std::pair<std::size_t, std::size_t> between(double from, double to) const;

  template <typename Visit>
  void visitIn(double azimuth, double half_width, double z, double height, Visit&& visit) const {
    for (const double shift : {-kTwoPi, 0.0, kTwoPi}) {
      const auto [begin, end] = between(azimuth + shift - half_width, azimuth + shift + half_width);
      for (std::size_t i = begin; i < end; ++i) {
        const Entry& e = entries_[i];
        if (std::abs(e.z - z) < height) visit(FootPoint{(e.azimuth - azimuth - shift) * e.radius, e.d, e.z});
      }
    }
  }

  Entries entries_;
  double behind_;  ///< distance from the shell of what is farther behind it than its noise reaches [m]
};

/// A robust plane z = z0 + slope d + along t + bend t^2 through the points in the profile's band, in which what is
/// known beforehand counts as observations (Bayesian least squares), so that few points lean on the prior and say so in
/// sigma.
/// @param start  elevation of the surface at the shell, to a few noises [m]
/// @return not valid for fewer than four points
FootFit fitFoundation(const std::vector<FootPoint>& points, const FootProfile& profile, double start,
                      const FootPrior& prior);

}  // namespace tank_datum
