#pragma once

#include <vector>

#include "core/units.h"
#include "foot/shell_line.h"
#include "shell/shell_edges.h"
#include "shell/shell_row.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

constexpr double kOneDegree = kTwoPi / 360.0;  ///< of the shell that a cell looks at, no more [rad]

/// Sets what the shell may be between stations that are more than a degree apart, as in a dent that they pass over.
void doubtBetween(const ShellOutline& outline, const ShellEdges& edges, const std::vector<Station>& stations,
                  std::vector<ShellCell>& row);

}  // namespace tank_datum
