#pragma once

#include <cstddef>
#include <vector>

#include "fit/ring_process.h"
#include "foot/foot_state.h"

namespace tank_datum {

/// Whether a ring bends at a station as it does nowhere else, and whether the shell is seen to go down there.
enum class Bend { None, Likely, Seen };

/// Stations about places where the stretches' own levels lie off the process, neighbours to the same side or down to
/// where the shell is seen to go: what the ring does elsewhere is no help there, as far as the process is alike. A
/// level that lies far off alone is doubted up to the levels beside it.
/// @param levels  of stretches at their middle stations, else NaN [m]
/// @param sigmas  their own standard errors [m]
std::vector<Bend> findBends(const Foot& foot, const std::vector<double>& levels, const std::vector<double>& sigmas,
                            const RingProcess& process);

/// A foundation settles in short dips. What rises so may lie on it: where the ring bends upwards its level is halfway,
/// and the standard error holds either.
RingProcess withRisesDoubted(RingProcess process);

/// The fit of a station's own window where the ring bends.
/// @param shared  standard error that no count of points lessens [m]
FootFit bentFit(const FootFit& own, const RingProcess& process, std::size_t station, double shared, Bend bend);

/// The standard error that a process has beside its own at a station whose window shows another level, beyond what both
/// err by: it may be the one or the other, as beside a dip that the process does not follow [m].
/// @param window  a fit of the station's own points and its neighbours'
double disagreement(const FootFit& window, const RingProcess& process, std::size_t station);

}  // namespace tank_datum
