#pragma once

#include <algorithm>
#include <cmath>

#include "stage_limits.h"

namespace tank_datum::bench {

/// What the machine's memory gives to loops that do nothing else.
struct MemorySpeed {
  MemorySpeeds read;  ///< summing numbers
  MemorySpeeds copy;  ///< copying them; bytes read and bytes written

  /// What stages are measured by: the quicker of the two.
  MemorySpeeds best() const { return {std::max(read.one, copy.one), std::max(read.two, copy.two)}; }
};

/// Keeps the quicker of two measurements of each.
inline void keepFastest(MemorySpeed& best, const MemorySpeed& speed) {
  const auto quicker = [](const MemorySpeeds& a, const MemorySpeeds& b) {
    return MemorySpeeds{std::fmax(a.one, b.one), std::fmax(a.two, b.two)};  // whatever is known yet
  };
  best = {quicker(best.read, speed.read), quicker(best.copy, speed.copy)};
}

/// The fastest of several passes over more than caches hold.
MemorySpeed measureMemory();

}  // namespace tank_datum::bench
