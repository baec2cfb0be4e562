#pragma once

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// How scans of foreign formats are read, as ScanOptions has it.
using OpenForeign = std::function<ScanBlocks(const ForeignScan& scan)>;

/// The command tank_datum: reads the arguments, writes the results and says what was found.
/// @param foreign  none: such scans are refused
/// @return the exit status
int datumCommand(int argc, char** argv, const OpenForeign& foreign = {});

}  // namespace tank_datum
