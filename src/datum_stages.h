#pragma once

#include <vector>

#include "tank_datum/datum.h"

namespace tank_datum {

/// @throws Error (Option) naming the first refused option
void requireValid(const DatumOptions& options);

/// The datum of every tank in a scan, the best seen first; of a scan without one, the reason.
/// @throws Error  as extractDatum
std::vector<Datum> extractEveryDatum(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks);

}  // namespace tank_datum
