#include "foot/lowest_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tank_datum {

void keepLowestLayer(std::vector<double>& values, double thickness) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest;
  std::vector<std::size_t> counts(static_cast<std::size_t>((*highest - low) / thickness) + 1, 0);
  for (const double v : values) ++counts[static_cast<std::size_t>((v - low) / thickness)];
  const std::size_t fullest = *std::max_element(counts.begin(), counts.end());
  std::size_t cell = 0;
  while (10 * counts[cell] < fullest) ++cell;
  const double middle_of_cell = low + (static_cast<double>(cell) + 0.5) * thickness;
  const auto far = [&](double v) { return std::abs(v - middle_of_cell) > 2.5 * thickness; };
  values.erase(std::remove_if(values.begin(), values.end(), far), values.end());
}

}  // namespace tank_datum
