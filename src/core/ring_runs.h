#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// Neighbours round a ring, first and last included; `last` may pass the end of the ring.
struct RingRun {
  std::size_t first, last;
};

/// Runs of places for which `is` holds, over gaps of up to `gap` others; one that passes the first place is one run.
std::vector<RingRun> runsRound(const std::vector<char>& is, std::size_t gap = 0);

}  // namespace tank_datum
