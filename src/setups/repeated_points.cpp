#include "setups/repeated_points.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/point_hash.h"
#include "locate/keep_points.h"

namespace tank_datum {
namespace {

using Hashed = std::pair<std::uint32_t, std::uint32_t>;  // hash and index of a point

/// Marks every point of the list that has the coordinates of an earlier one.
std::vector<std::uint32_t> repetitionsAmong(std::vector<Hashed> list, const Points& points) {
  std::sort(list.begin(), list.end());
  std::vector<std::uint32_t> repeated;
  for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end) {
    for (end = begin + 1; end < list.size() && list[end].first == list[begin].first; ++end) {
      const Eigen::Vector3d& p = points[list[end].second];
      const bool known = std::any_of(list.begin() + static_cast<std::ptrdiff_t>(begin),
                                     list.begin() + static_cast<std::ptrdiff_t>(end),
                                     [&](const Hashed& other) { return points[other.second] == p; });
      if (known) repeated.push_back(list[end].second);
    }
  }
  return repeated;
}

/// The points of the lowest 2^bits-th of all hashes.
std::vector<Hashed> hashesOf(const Ring& ring, int bits) {
  std::vector<Hashed> list;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const std::uint32_t hash = pointHash(ring.points[i]);
    if (bits == 0 || hash >> (32 - bits) == 0) list.emplace_back(hash, static_cast<std::uint32_t>(i));
  }
  return list;
}

std::vector<double> countBySetup(const Ring& ring, const std::vector<std::uint32_t>& indices) {
  std::vector<double> counts(ring.setupCount(), 0.0);
  for (const std::uint32_t i : indices) counts[ring.setupOf(i)] += 1.0;
  return counts;
}

std::vector<double> sharesOf(const Ring& ring, const std::vector<Hashed>& list,
                             const std::vector<std::uint32_t>& repeated) {
  std::vector<std::uint32_t> all;
  for (const Hashed& one : list) all.push_back(one.second);
  const std::vector<double> of_all = countBySetup(ring, all);
  std::vector<double> shares = countBySetup(ring, repeated);
  for (std::size_t s = 0; s < shares.size(); ++s) shares[s] = of_all[s] > 0.0 ? shares[s] / of_all[s] : 0.0;
  return shares;
}

}  // namespace

RepeatedPoints removeRepeated(Ring& ring) {
  constexpr int kSampleBits = 6;         // one point in 64 tells whether it is worth looking at all
  constexpr double kByChance = 0.3;      // share of a setup's points
  constexpr std::size_t kSmall = 20000;  // a ring of so many is looked at whole
  RepeatedPoints result;
  const int bits = ring.points.size() > kSmall ? kSampleBits : 0;
  const std::vector<Hashed> sample = hashesOf(ring, bits);
  const std::vector<double> shares = sharesOf(ring, sample, repetitionsAmong(sample, ring.points));
  result.of_setups.assign(shares.size(), 0.0);
  if (*std::max_element(shares.begin(), shares.end()) < kByChance) return result;
  const std::vector<Hashed> all = hashesOf(ring, 0);
  const std::vector<std::uint32_t> repeated = repetitionsAmong(all, ring.points);
  result.of_setups = sharesOf(ring, all, repeated);
  result.removed = repeated.size();
  std::vector<char> gone(ring.points.size(), 0);
  for (const std::uint32_t i : repeated) gone[i] = 1;
  keepPoints(ring, [&](std::size_t i) { return !gone[i]; });
  return result;
}

}  // namespace tank_datum
