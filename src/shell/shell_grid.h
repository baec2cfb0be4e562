#pragma once

#include <cstddef>
#include <vector>

#include "shell/shell_bands.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/shell/shell_survey.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The shell at one height of one station, about the datum's centre.
struct ShellCell {
  double radius = kUnknown;   ///< [m]
  double sigma = kUnknown;    ///< its standard error [m]
  double shared = 1.0;        ///< the arc its points come from, in stations; the neighbours share what is beyond one
  std::size_t points = 0;     ///< 0 when the shell is not seen here
  bool runs_on = false;       ///< traced to the next station that is seen
  double doubted = kUnknown;  ///< radius of what was not taken for the shell, though it may be it [m]

  bool seen() const { return points > 0; }
};

/// One cell per height and station.
struct ShellGrid {
  std::vector<double> heights;                ///< at which something was seen, lowest first [m]
  std::vector<std::vector<ShellCell>> cells;  ///< by height, then by station
  double step = 0;                            ///< arc between stations [m]
};

/// Fits the shell at every height of every station with a robust local surface. Heights count from the station's own
/// elevation, from between its neighbours' where that is unknown.
ShellGrid fitShellGrid(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                       const ShellOptions& options);

/// Keeps the largest connected part of the grid. A shell bends and leans by little from cell to cell; what stands in
/// front of it - stairs, a pipe, a box over many degrees - begins and ends with a jump.
void keepConnected(ShellGrid& grid);

}  // namespace tank_datum
