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

/// The runs from each place at which one begins to the next such place; none of a ring with fewer than two.
/// @param count      of places
/// @param begins_at  whether a run begins at a place
template <typename BeginsAt>
std::vector<RingRun> runsBetween(std::size_t count, const BeginsAt& begins_at) {
  std::vector<std::size_t> starts;
  for (std::size_t k = 0; k < count; ++k) {
    if (begins_at(k)) starts.push_back(k);
  }
  std::vector<RingRun> runs;
  for (std::size_t s = 0; s < starts.size() && starts.size() > 1; ++s)
    runs.push_back({starts[s], s + 1 < starts.size() ? starts[s + 1] - 1 : starts[0] + count - 1});
  return runs;
}

}  // namespace tank_datum
