#pragma once

#include <algorithm>

#include "stage_limits.h"

namespace tank_datum::bench {

/// What the machine's memory gives to loops that do nothing else.
struct MemorySpeed {
  MemorySpeeds read;  ///< summing numbers
  MemorySpeeds copy;  ///< copying them; bytes read and bytes written

  /// What stages are measured by: the quicker of the two.
  MemorySpeeds best() const { return {std::max(read.one, copy.one), std::max(read.two, copy.two)}; }
};

/// The fastest of several passes over more than caches hold.
MemorySpeed measureMemory();

}  // namespace tank_datum::bench
