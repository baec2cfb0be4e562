#pragma once

#include <vector>

#include "fit/ring_process.h"
#include "foot/foot_profile.h"
#include "foot/foot_roughness.h"
#include "foot/foot_state.h"

namespace tank_datum {

/// Windows round the ring, a few patches long, fitted: over longer ones the datum bends as patches do.
std::vector<FittedPoints> patchWindows(const Foot& foot, const FootPass& pass);

/// Roughness of the band from what points share that lie near each other, along the shell and across, which range noise
/// does not make alike; what windows' fits take away is known. Patches may be longer than a lip is wide.
/// @return nothing where windows of ten points or more tell of none
Roughness patchesOf(const std::vector<FittedPoints>& windows, const FootProfile& profile);

/// What the patches of a rough surface do to the levels of stations.
struct LevelRoughness {
  double variance = 0;  ///< of a station's level [m^2]
  double length = 0;    ///< of the patches; 0: not known, each station has its own [m]
  double arc = 0;       ///< of a station [m]

  /// Variance of a level over a longer arc [m^2].
  double over(double longer) const;
  /// What slopes across a band differ by that patches do not explain.
  /// @param seen  what they differ by over longer arcs [m/m]
  double slopesBeyond(double seen, const FootProfile& profile, double longer) const;
  /// What a process leaves out of its variance at a place: it takes levels to err alone, and patches reach over several
  /// of them [m^2].
  /// @param own  standard error of the station's level [m]
  double leftOutBy(const RingProcess& process, std::size_t place, double own) const;
};

/// @param least  that the level's variance is known to be [m^2]
LevelRoughness levelRoughness(const Roughness& patches, const FootProfile& profile, double arc, double least);

}  // namespace tank_datum
