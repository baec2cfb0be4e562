#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/refusal.h"
#include "tank_datum/edge/find_edge_points.h"

namespace tank_datum {

std::vector<std::int32_t> growCandidates(const Normals& normals, const GrowingOptions& options, int threads) {
  refuseFirst(firstError(options));
  const auto k = static_cast<std::size_t>(normals.k);
  const float limit = static_cast<float>(portable::cos(options.angle));
  std::vector<std::atomic<char>> marked(normals.size());
  forEachRun(normals.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t seed = begin; seed < end; ++seed) {
      for (std::size_t j = seed * k; j < (seed + 1) * k; ++j) {
        const auto neighbour = static_cast<std::size_t>(normals.neighbours[j]);
        if (std::abs(normals.normals[seed].dot(normals.normals[neighbour])) < limit) {
          marked[neighbour].store(1, std::memory_order_relaxed);
        }
      }
    }
  });
  std::vector<std::int32_t> candidates;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (marked[i]) candidates.push_back(static_cast<std::int32_t>(i));
  }
  return candidates;
}

}  // namespace tank_datum
