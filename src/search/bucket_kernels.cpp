#include "search/bucket_kernels.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

#include "core/cpu_dispatch.h"

namespace tank_datum {
namespace {

using Floats = float __attribute__((vector_size(4 * kLanes)));
using Integers = std::int32_t __attribute__((vector_size(4 * kLanes)));

constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

std::uint64_t foundPoint(const HitColumns& hits, std::size_t i) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(hits.squared[i])) << 32 | hits.numbers[i];
}

void sortByComparing(const HitColumns& hits, std::size_t count, std::size_t k, std::uint64_t* to) {
  std::vector<std::uint64_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = foundPoint(hits, i);
  std::partial_sort_copy(all.begin(), all.end(), to, to + k);
}

}  // namespace

TANK_DATUM_CPU_DISPATCH
std::size_t keepWithin(const PointColumns& points, const float* place, float squared_limit, const HitColumns& hits) {
  const float px = place[0], py = place[1], pz = place[2];
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < points.count; begin += kLanes) {
    Floats x, y, z;
    std::memcpy(&x, points.x + begin, sizeof x);
    std::memcpy(&y, points.y + begin, sizeof y);
    std::memcpy(&z, points.z + begin, sizeof z);
    const Floats dx = px - x, dy = py - y, dz = pz - z, squared = (dx * dx + dy * dy) + dz * dz;
    const Integers within = squared <= squared_limit;
    std::int64_t any[kLanes / 2];
    std::memcpy(any, &within, sizeof any);
    if ((any[0] | any[1] | any[2] | any[3]) == 0) continue;
    const std::size_t lanes = std::min(kLanes, points.count - begin);
    for (std::size_t lane = 0; lane < lanes; ++lane) {  // without a branch: who is within is random
      std::memcpy(hits.squared + kept, reinterpret_cast<const char*>(&squared) + 4 * lane, 4);
      hits.numbers[kept] = points.numbers[begin + lane];
      kept += static_cast<std::size_t>(within[lane] & 1);
    }
  }
  return kept;
}

/// A hit's place is how many are nearer. With some thirty hits, comparing all with all, without a branch, is quicker
/// than a sort. Of those equally far the lower number has the place; unless it is the last, they leave one empty.
TANK_DATUM_CPU_DISPATCH
void sortNearest(const HitColumns& hits, std::size_t count, std::size_t k, std::uint64_t* to) {
  constexpr std::size_t kFew = 128;
  if (count > kFew) return sortByComparing(hits, count, k, to);
  std::fill_n(to, k, kNone);
  std::fill(hits.squared + count, hits.squared + padded(count), std::numeric_limits<std::int32_t>::max());
  for (std::size_t begin = 0; begin < count; begin += kLanes) {
    Integers own, place{};
    std::memcpy(&own, hits.squared + begin, sizeof own);
    for (std::size_t j = 0; j < count; ++j) place -= hits.squared[j] < own;
    for (std::size_t lane = 0; lane < std::min(kLanes, count - begin); ++lane) {
      const auto at = static_cast<std::size_t>(place[lane]);
      if (at < k) to[at] = std::min(to[at], foundPoint(hits, begin + lane));
    }
  }
  if (std::find(to, to + k, kNone) != to + k) sortByComparing(hits, count, k, to);
}

}  // namespace tank_datum
