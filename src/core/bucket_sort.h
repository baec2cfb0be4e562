#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "tank_datum/core/default_init_allocator.h"

namespace tank_datum {

/// Sorts in several threads: counts into buckets, part by part, then sorts each bucket. The order is that of `less`
/// whatever the number of threads; values that it holds for equal may come in any, but the same, order.
/// @param bucketOf  of a value, below `buckets`; must rise with the order that less has
template <typename T, typename BucketOf, typename Less>
void sortByBuckets(std::vector<T, DefaultInitAllocator<T>>& values, std::size_t buckets, const BucketOf& bucketOf,
                   const Less& less, int threads) {
  constexpr std::size_t kParts = 16;
  const auto beginOf = [&](std::size_t part) { return values.size() * part / kParts; };
  std::vector<std::vector<std::size_t>> starts(kParts);
  forEachIndex(kParts, threads, [&](std::size_t part) {
    starts[part].assign(buckets + 1, 0);
    for (std::size_t i = beginOf(part); i < beginOf(part + 1); ++i) ++starts[part][bucketOf(values[i])];
  });
  std::size_t next = 0;
  for (std::size_t bucket = 0; bucket <= buckets; ++bucket) {
    for (auto& of_part : starts) next += std::exchange(of_part[bucket], next);
  }
  const std::vector<std::size_t> first = starts.front();
  std::vector<T, DefaultInitAllocator<T>> sorted(values.size());
  forEachIndex(kParts, threads, [&](std::size_t part) {
    for (std::size_t i = beginOf(part); i < beginOf(part + 1); ++i) {
      sorted[starts[part][bucketOf(values[i])]++] = values[i];
    }
  });
  constexpr std::size_t kTogether = 32;  // buckets to one call of a thread
  const auto at = [&](std::size_t bucket) { return sorted.begin() + static_cast<std::ptrdiff_t>(first[bucket]); };
  forEachIndex((buckets + kTogether - 1) / kTogether, threads, [&](std::size_t group) {
    const std::size_t end = std::min(buckets, (group + 1) * kTogether);
    for (std::size_t bucket = group * kTogether; bucket < end; ++bucket) std::sort(at(bucket), at(bucket + 1), less);
  });
  values = std::move(sorted);
}

}  // namespace tank_datum
