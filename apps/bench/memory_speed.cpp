#include "memory_speed.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/parallel.h"

namespace tank_datum::bench {
namespace {

using Numbers = std::vector<std::uint64_t>;
constexpr std::size_t kCount = std::size_t{1} << 24;  // 128 MB
constexpr std::size_t kParts = 64;
constexpr std::size_t kOfPart = kCount / kParts;

/// @param work  on the part-th of the parts
template <typename Work>
double fastestSeconds(int threads, const Work& work) {
  constexpr int kPasses = 5;
  double fastest = 0.0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const auto start = std::chrono::steady_clock::now();
    forEachIndex(kParts, threads, work);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fastest = pass == 0 ? seconds : std::min(fastest, seconds);
  }
  return fastest;
}

}  // namespace

MemorySpeed measureMemory() {
  const Numbers from(kCount, 1);
  Numbers to(kCount, 0);
  std::vector<std::uint64_t> sums(kParts);
  const auto partOf = [](auto& numbers, std::size_t part) {
    return numbers.begin() + static_cast<std::ptrdiff_t>(part * kOfPart);
  };
  const auto sum = [&](std::size_t part) {
    const auto begin = partOf(from, part);
    sums[part] += std::accumulate(begin, begin + kOfPart, std::uint64_t{0});  // kept, lest the loop is left out
  };
  const auto copy = [&](std::size_t part) { std::copy_n(partOf(from, part), kOfPart, partOf(to, part)); };
  constexpr double kBytes = 8.0 * kCount;
  return {{kBytes / fastestSeconds(1, sum), kBytes / fastestSeconds(2, sum)},
          {2.0 * kBytes / fastestSeconds(1, copy), 2.0 * kBytes / fastestSeconds(2, copy)}};
}

}  // namespace tank_datum::bench
