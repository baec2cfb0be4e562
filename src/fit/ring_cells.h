#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// The value at an azimuth of what is known in equal cells round a ring, NaN where it is not: straight between the two
/// cells beside, else the nearest's, and NaN where none is known within three cells.
/// @param cells    of which the first begins at azimuth 0
/// @param azimuth  [rad]
double betweenCells(const std::vector<double>& cells, double azimuth);

/// The cell that an azimuth [rad] lies in of so many equal ones, of which the first begins at 0.
std::size_t ringCell(double azimuth, std::size_t cells);

/// The azimuth of a cell's middle [rad].
double middleOfCell(std::size_t cell, std::size_t cells);

/// Where the values of a cell lie densest; NaN of fewer than five.
/// @param values  in no order; sorted on return
double densestOfCell(std::vector<double>& values);

}  // namespace tank_datum
