#pragma once

#include <vector>

namespace tank_datum {

/// Keeps the lowest of the layers that the values lie in: what hangs over the foundation (drip ring, pipe, nozzle) is
/// seen above it, nothing is seen below. A layer is a cell of `thickness` with at least a tenth of the fullest cell's
/// values; two cells on either side of it belong to it.
void keepLowestLayer(std::vector<double>& values, double thickness);

}  // namespace tank_datum
