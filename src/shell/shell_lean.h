#pragma once

#include <vector>

#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What the slopes have in common, as a lean of the whole, told from lobes that grow with height, which would pass for
/// one beside a gap. Not valid with too few of them, nor where its interval (95 %) is wider than any shell leans: over
/// a short arc a lean and a taper are alike.
/// @param options  how azimuths are counted
Lean leanOf(const std::vector<Plumbness>& plumbness, const StationOptions& options);

}  // namespace tank_datum
