#include "core/ring_runs.h"

#include <algorithm>

namespace tank_datum {

std::vector<RingRun> runsRound(const std::vector<char>& is, std::size_t gap) {
  const std::size_t count = is.size();
  std::vector<RingRun> runs;
  const auto start = static_cast<std::size_t>(std::find(is.begin(), is.end(), 0) - is.begin());
  for (std::size_t k = start; k < start + count; ++k) {
    if (!is[k % count]) continue;
    if (!runs.empty() && k - runs.back().last <= gap + 1) {
      runs.back().last = k;
    } else {
      runs.push_back({k, k});
    }
  }
  const bool joined = runs.size() > 1 && runs.front().first + count - runs.back().last <= gap + 1;
  if (joined) {
    runs.back().last = runs.front().last + count;
    runs.erase(runs.begin());
  }
  return runs;
}

}  // namespace tank_datum
