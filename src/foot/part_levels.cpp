#include "foot/part_levels.h"

#include <utility>

#include "tank_datum/core/unknown.h"

namespace tank_datum {

PerPart<WeightedValue> mediansOf(PerPart<std::vector<double>> heights) {
  PerPart<WeightedValue> levels;
  for (std::size_t part = 0; part < kParts; ++part) {
    const auto weight = static_cast<double>(heights[part].size());
    levels[part] = {median(std::move(heights[part])), weight};
  }
  return levels;
}

PerPart<double> levelsIn(const std::vector<PerPart<WeightedValue>>& own, std::size_t first, std::size_t last) {
  constexpr double kFewest = 10.0;
  PerPart<double> levels;
  for (std::size_t part = 0; part < kParts; ++part) {
    std::vector<WeightedValue> of_arc;
    double points = 0.0;
    for (std::size_t k = first; k <= last; ++k) {
      const WeightedValue& level = own[k % own.size()][part];
      if (level.weight > 0.0) of_arc.push_back(level), points += level.weight;
    }
    levels[part] = points < kFewest ? kUnknown : weightedMedian(std::move(of_arc));
  }
  return levels;
}

}  // namespace tank_datum
