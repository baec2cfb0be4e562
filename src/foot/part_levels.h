#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/statistics.h"

namespace tank_datum {

constexpr std::size_t kParts = 3;  ///< that a section is looked at in, outwards

/// Something of each part.
template <typename T>
using PerPart = std::array<T, kParts>;

/// A station's level in each part: the median of its points' heights, with their number for a weight.
PerPart<WeightedValue> mediansOf(PerPart<std::vector<double>> heights);

/// The same of an arc of stations; NaN where there are few points.
/// @param own          of every station
/// @param first, last  stations, counted on round the ring
PerPart<double> levelsIn(const std::vector<PerPart<WeightedValue>>& own, std::size_t first, std::size_t last);

}  // namespace tank_datum
