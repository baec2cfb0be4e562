#pragma once

#include <cstddef>
#include <vector>

#include "shell/shell_bands.h"
#include "shell/shell_row.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// One cell per height and station.
struct ShellGrid {
  std::vector<double> heights;                ///< at which something was seen, lowest first [m]
  std::vector<std::vector<ShellCell>> cells;  ///< by height, then by station
  double step = 0;                            ///< arc between stations [m]
  Side side = Side::Outside;                  ///< that the shell is seen from
};

/// Fits the shell at every height of every station with a robust local surface. Heights count from the station's own
/// elevation, from between its neighbours' where that is unknown.
ShellGrid fitShellGrid(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                       const ShellOptions& options);

/// Keeps the connected part of the grid that is seen most in the lowest row that goes half round the tank, where the
/// datum was found: cladding may hide more of the shell above. A shell bends and leans by little from cell to cell;
/// what stands in front of it - stairs, a pipe, a box over many degrees - begins and ends with a jump. So does a
/// recess: what is left out behind the shell is doubted.
void keepConnected(ShellGrid& grid);

}  // namespace tank_datum
