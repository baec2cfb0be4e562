#include "tank_datum/edge/region_growing.h"

#include <omp.h>

#include <cmath>
#include <cstdio>

namespace tank_datum {

std::string firstError(const GrowingOptions& options) {
  constexpr double kRightAngle = 1.5707963267948966;
  if (options.angle > 0.0 && options.angle < kRightAngle) return {};
  char text[80];
  std::snprintf(text, sizeof text, "growing.angle = %g rad (must be > 0 and < pi/2)", options.angle);
  return text;
}

std::vector<std::int32_t> growCandidates(const Normals& normals, const GrowingOptions& options, int threads) {
  const auto k = static_cast<std::size_t>(normals.k);
  const float limit = static_cast<float>(std::cos(options.angle));
  std::vector<char> marked(normals.size(), 0);
  const auto count = static_cast<std::ptrdiff_t>(normals.size());
#pragma omp parallel for schedule(static) num_threads(threads > 0 ? threads : omp_get_max_threads())
  for (std::ptrdiff_t row = 0; row < count; ++row) {
    const auto seed = static_cast<std::size_t>(row);
    for (std::size_t j = seed * k; j < (seed + 1) * k; ++j) {
      const auto neighbour = static_cast<std::size_t>(normals.neighbours[j]);
      if (std::abs(normals.normals[seed].dot(normals.normals[neighbour])) < limit) {
#pragma omp atomic write
        marked[neighbour] = 1;
      }
    }
  }
  std::vector<std::int32_t> candidates;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) candidates.push_back(static_cast<std::int32_t>(i));
  }
  return candidates;
}

}  // namespace tank_datum
