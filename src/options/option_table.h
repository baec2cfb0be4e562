#pragma once

#include <vector>

#include "options/option.h"
#include "options/run_options.h"

namespace tank_datum {

/// Every option, once; each holds a place in `run`, which must outlive it. From them come the command line,
/// --print-config, datum.json's `options`, Python's keywords, the pages about them, and what is refused.
std::vector<Option> optionsOf(RunOptions& run);

/// Those of a comparison of two surveys.
std::vector<Option> movementOptionsOf(MovementOptions& movement);

}  // namespace tank_datum
