#pragma once

#include <vector>

#include "foot/shell_line.h"

namespace tank_datum {

/// Where another wall than the shell stands, as cladding on a part of it: runs of lines off the circle that begin and
/// end with a step, steeper than any shell bends.
/// @param strays  lines that are off the circle
/// @param arc     between the lines [m]
std::vector<bool> findOtherWalls(const std::vector<ShellLine>& lines, const std::vector<bool>& strays, double arc);

}  // namespace tank_datum
