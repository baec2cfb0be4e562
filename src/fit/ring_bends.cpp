#include "fit/ring_bends.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// What one process makes of the ring.
struct Candidate {
  RingProcess ring;
  std::vector<double> likely;  ///< logarithm of each value's density by what the others say; 0 where there is none
};

/// @param ring  the values smoothed by the process
Candidate candidateOf(const RingData& data, const ProcessParameters& p, RingProcess ring) {
  Candidate candidate{std::move(ring), std::vector<double>(data.values.size(), 0.0)};
  const OffOthers off = offOthers(data, p, candidate.ring);
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    if (!std::isfinite(data.values[i])) continue;
    candidate.likely[i] = -0.5 * square(off.distance[i] / off.sigma[i]) - portable::log(off.sigma[i]);
  }
  return candidate;
}

bool isAnyKnown(const RingData& data, std::size_t place, std::size_t reach) {
  const std::size_t count = data.values.size();
  for (std::size_t j = place + count - reach; j <= place + count + reach; ++j) {
    if (std::isfinite(data.values[j % count])) return true;
  }
  return false;
}

}  // namespace

void followBends(const RingData& data, const ProcessParameters& usual,
                 const std::vector<ProcessParameters>& alternatives, RingProcess& result) {
  constexpr double kRarely = 6.0;               // logarithm of the odds against an alternative
  constexpr double kReach = 5.0 * kPi / 180.0;  // to either side
  result.bent.assign(data.values.size(), 0.0);
  if (alternatives.empty()) return;
  std::vector<Candidate> all{candidateOf(data, usual, result)};
  for (const ProcessParameters& p : alternatives) {
    RingProcess ring = result;
    smoothRing(data, p, ring);
    all.push_back(candidateOf(data, p, std::move(ring)));
  }
  const double rare = kRarely + portable::log(static_cast<double>(alternatives.size()));
  const std::size_t count = data.values.size();
  const auto reach = std::min(static_cast<std::size_t>(std::lround(kReach / data.step)), (count - 1) / 2);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isAnyKnown(data, i, reach)) continue;
    std::vector<double> likely{0.0};  // beside the usual process
    for (std::size_t k = 1; k < all.size(); ++k) {
      likely.push_back(-rare);
      for (std::size_t j = i + count - reach; j <= i + count + reach; ++j)
        likely.back() += all[k].likely[j % count] - all.front().likely[j % count];
    }
    const double most = *std::max_element(likely.begin(), likely.end()), from = all.front().ring.value[i];
    double shares = 0.0, mean = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double share = portable::exp(likely[k] - most), off = all[k].ring.value[i] - from;
      shares += share;
      mean += share * off;
      squares += share * (square(all[k].ring.sigma[i]) + square(off));
    }
    mean /= shares;
    result.bent[i] = mean;
    result.value[i] = from + mean;
    result.sigma[i] = std::sqrt(std::max(0.0, squares / shares - square(mean)));
  }
}

}  // namespace tank_datum
