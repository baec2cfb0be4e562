#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace tank_datum {

/// What work(begin, end) gives for each of some consecutive parts of 0 .. count - 1, in their order, worked at by
/// several threads. The parts do not depend on the number of threads; some are empty where there are few indices.
/// @param threads  see threadCount()
template <typename Work>
auto ofParts(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t kParts = 16;
  std::vector<decltype(work(count, count))> results(kParts);
  forEachIndex(kParts, threads,
               [&](std::size_t part) { results[part] = work(count * part / kParts, count * (part + 1) / kParts); });
  return results;
}

/// The least and the largest of valueAt(i) for i = 0 .. count - 1, of which there is one at least.
template <typename ValueAt>
auto rangeOf(std::size_t count, int threads, const ValueAt& valueAt) {
  const auto first = valueAt(std::size_t{0});
  const auto ranges = ofParts(count, threads, [&](std::size_t begin, std::size_t end) {
    std::pair part{first, first};
    for (std::size_t i = begin; i < end; ++i) {
      const auto value = valueAt(i);
      part = {std::min(part.first, value), std::max(part.second, value)};
    }
    return part;
  });
  std::pair range{first, first};
  for (const auto& part : ranges) range = {std::min(range.first, part.first), std::max(range.second, part.second)};
  return range;
}

/// How many of 0 .. count - 1 pass a test.
template <typename Test>
std::size_t countWhere(std::size_t count, int threads, const Test& passes) {
  const auto counts = ofParts(count, threads, [&](std::size_t begin, std::size_t end) {
    std::size_t of_part = 0;
    for (std::size_t i = begin; i < end; ++i) of_part += passes(i) ? 1 : 0;
    return of_part;
  });
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// The values of all parts, one after the other.
template <typename Values>
Values concatenated(const std::vector<Values>& parts) {
  std::vector<std::size_t> starts(1);
  for (const Values& part : parts) starts.push_back(starts.back() + part.size());
  Values all(starts.back());
  forEachIndex(parts.size(), 0, [&](std::size_t part) {
    std::copy(parts[part].begin(), parts[part].end(), all.begin() + static_cast<std::ptrdiff_t>(starts[part]));
  });
  return all;
}

}  // namespace tank_datum
