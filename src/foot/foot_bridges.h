#pragma once

#include <vector>

#include "fit/ring_process.h"
#include "foot/foot_state.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What gaps are bridged with.
struct BridgeScales {
  Circle circle;      ///< of the shell
  double sigma_bend;  ///< of the datum's second derivative along the shell [1/m]
  StationOptions stations;
};

/// The stations with the short gaps among them bridged: over the shell, and where there is one along the process. Gaps
/// below whose bridge the shell is seen to go on have no datum (Unmeasured::ShellBelow).
/// @param process  what the stations follow; may be not valid
std::vector<StationDatum> withGapsBridged(const std::vector<StationDatum>& stations, const RingProcess& process,
                                          const Foot& foot, const BridgeScales& scales);

}  // namespace tank_datum
