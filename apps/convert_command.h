#pragma once

#include "datum_command.h"

namespace tank_datum {

/// The command tank_datum_convert: scans of any format to one PCD.
/// @param foreign  none: scans of foreign formats are refused
/// @return the exit status
int convertCommand(int argc, char** argv, const OpenForeign& foreign = {});

}  // namespace tank_datum
