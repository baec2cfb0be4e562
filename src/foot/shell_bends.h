#pragma once

#include <vector>

#include "foot/polar_ring.h"
#include "foot/shell_line.h"

namespace tank_datum {

/// The lines of the shell's foot: where a shell bends there, as it does where it bulges, each of as much of it from the
/// foot on as is straight. Of nested parts that is the largest which agrees with all smaller ones about where the foot
/// is (intersection of confidence intervals). A shell whose noise hides that keeps the lines it has.
/// @param lines    one per equal step of azimuth, counter-clockwise
/// @param windows  that they were fitted in
std::vector<ShellLine> linesAtFoot(const PolarRing& ring, const std::vector<ShellLine>& lines,
                                   const std::vector<ShellWindow>& windows);

}  // namespace tank_datum
