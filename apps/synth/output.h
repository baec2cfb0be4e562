#pragma once

#include "command_line.h"
#include "scanner.h"

namespace tank_datum::synth {

/// Scans the scene into the PCD file or files of the command, with the truth beside them. Each file appears whole.
/// @throws Error (File)
ScanSummary writeScan(const Scene& scene, const Command& command);

}  // namespace tank_datum::synth
