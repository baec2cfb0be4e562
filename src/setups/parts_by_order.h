#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Where the parts of a ring begin that were scanned one after the other, told by the order of its points: a scanner
/// turns, so that the arcs of one setup follow each other, and an arc that comes again far later in the file was seen
/// from another setup. A setup whose sweep begins or is cut before the shell may be two parts.
/// @return indices of points, rising, the first 0; empty where the order says nothing, as of rows, tiles or shuffled
///         points, or where no part sees what another one sees
std::vector<std::size_t> partsByOrder(const Ring& ring, const Tank& tank, int threads = 0);

}  // namespace tank_datum
