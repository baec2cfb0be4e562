#include "search/voxel_sample.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bucket_sort.h"
#include "core/fast_floor.h"
#include "core/morton_code.h"
#include "core/parallel.h"
#include "core/parts.h"
#include "core/point_hash.h"
#include "core/portable_math.h"

namespace tank_datum {
namespace {

constexpr double kHalfRange = double(1 << 20) - 1;  // voxels on each side of the origin that 21 bits can number
constexpr std::size_t kMostDoublings = 20;          // then there are the octants about the origin only

std::uint64_t indexOf(double coordinate, double voxel) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(fastFloor(coordinate / voxel)) + (1 << 20));
}

/// A point on the Morton curve of the smallest voxels.
struct Place {
  std::uint64_t code;
  std::uint32_t rank, index;
};

using Places = std::vector<Place, DefaultInitAllocator<Place>>;

Places sortedPlaces(const Points& points, double voxel, int threads) {
  constexpr std::size_t kBuckets = 4096;
  Places places(points.size());
  forEachRun(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = points[i];
      places[i] = {mortonCode(indexOf(p.x(), voxel), indexOf(p.y(), voxel), indexOf(p.z(), voxel)), pointHash(p),
                   static_cast<std::uint32_t>(i)};
    }
  });
  const auto by_code = [](const Place& a, const Place& b) { return a.code < b.code; };
  const auto [first, last] = rangeOf(places.size(), threads, [&](std::size_t i) { return places[i].code; });
  const std::uint64_t lowest = first, span = last - lowest;
  int shift = 0;
  while (span >> shift >= kBuckets) ++shift;
  const auto bucket_of = [&](const Place& p) { return static_cast<std::size_t>((p.code - lowest) >> shift); };
  sortByBuckets(places, kBuckets, bucket_of, by_code, threads);
  return places;
}

/// After how many doublings of the smallest voxels each place and the one before it on the curve are in one voxel, and
/// behind the last place; kMostDoublings + 1: never.
using Meetings = std::vector<std::uint8_t, DefaultInitAllocator<std::uint8_t>>;

Meetings meetingsOf(const Places& places, int threads) {
  constexpr std::uint8_t kNever = kMostDoublings + 1;
  Meetings meetings(places.size() + 1);
  forEachRun(places.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = std::max<std::size_t>(1, begin); i < end; ++i) {
      const std::uint64_t apart = places[i].code ^ places[i - 1].code;
      const int bits = apart == 0 ? 0 : 64 - __builtin_clzll(apart);
      meetings[i] = std::min(static_cast<std::uint8_t>((bits + 2) / 3), kNever);
    }
  });
  meetings.front() = meetings.back() = kNever;
  return meetings;
}

/// A number for each of so many doublings, and for never.
using ByDoublings = std::array<std::size_t, kMostDoublings + 2>;

/// How many of some indices have which number of doublings.
template <typename DoublingsAt>
ByDoublings countByDoublings(std::size_t count, int threads, const DoublingsAt& doublingsAt) {
  ByDoublings sum{};
  for (const ByDoublings& part : ofParts(count, threads, [&](std::size_t begin, std::size_t end) {
         ByDoublings of_part{};
         for (std::size_t i = begin; i < end; ++i) ++of_part[doublingsAt(i)];
         return of_part;
       }))
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
  return sum;
}

/// How often the voxels must be doubled for at most so many to hold all places; they are counted on all levels at once.
std::size_t doublingsFor(const Meetings& meetings, std::size_t max_voxels, int threads) {
  // how many neighbours so many doublings bring together
  const ByDoublings parted =
      countByDoublings(meetings.size() - 2, threads, [&](std::size_t i) { return meetings[i + 1]; });
  std::size_t voxels = 1, doublings = kMostDoublings + 1;
  while (doublings > 0 && voxels + parted[doublings] <= max_voxels) voxels += parted[doublings--];
  return std::min(doublings, kMostDoublings);
}

/// The share of the places that are alone in their voxel, level by level.
std::vector<double> sharesAlone(const Meetings& meetings, int threads) {
  const std::size_t places = meetings.size() - 1;
  // how many meet their nearer neighbour at a level
  const ByDoublings met =
      countByDoublings(places, threads, [&](std::size_t i) { return std::min(meetings[i], meetings[i + 1]); });
  std::vector<double> shares;
  std::size_t left = places;
  for (std::size_t level = 0; level <= kMostDoublings; ++level) {
    left -= met[level];
    shares.push_back(static_cast<double>(left) / static_cast<double>(places));
  }
  return shares;
}

}  // namespace

double largestCoordinate(const Points& points, int threads) {
  if (points.empty()) return 0.0;
  return rangeOf(points.size(), threads, [&](std::size_t i) { return points[i].cwiseAbs().maxCoeff(); }).second;
}

VoxelSample::VoxelSample(const Points& points, std::size_t max_points, double voxel, int threads)
    : voxel_(voxel), finest_(voxel), doublings_left_(kMostDoublings) {
  if (points.empty()) return;
  const double reach = largestCoordinate(points, threads);
  while (!(reach / voxel_ < kHalfRange)) voxel_ *= 2.0;
  finest_ = voxel_;
  const Places places = sortedPlaces(points, voxel_, threads);
  const Meetings meetings = meetingsOf(places, threads);
  const std::size_t doublings = doublingsFor(meetings, max_points, threads), bits = 3 * doublings;
  const auto begins_voxel = [&](std::size_t i) { return meetings[i] > doublings; };
  voxels_ = concatenated(ofParts(places.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Voxel> of_part;  // that begin in it
    while (begin < end && !begins_voxel(begin)) ++begin;
    for (std::size_t first = begin, next = begin; first < end; first = next) {
      std::size_t lowest = first;
      for (next = first + 1; !begins_voxel(next); ++next) {
        if (places[next].rank < places[lowest].rank) lowest = next;
      }
      of_part.push_back({places[first].code >> bits, places[lowest].rank, static_cast<std::uint32_t>(next - first),
                         points[places[lowest].index]});
    }
    return of_part;
  }));
  alone_ = sharesAlone(meetings, threads);
  doublings_left_ -= doublings;
  voxel_ = std::ldexp(voxel_, static_cast<int>(doublings));
}

void VoxelSample::coarsen() {
  voxel_ *= 2.0;
  if (doublings_left_ == 0) return;
  --doublings_left_;
  std::size_t merged = 0;
  for (Voxel& voxel : voxels_) {
    voxel.code >>= 3;
    if (merged == 0 || voxels_[merged - 1].code != voxel.code) {
      voxels_[merged++] = voxel;
      continue;
    }
    Voxel& held = voxels_[merged - 1];
    held.count += voxel.count;
    if (voxel.rank < held.rank) held.rank = voxel.rank, held.point = voxel.point;
  }
  voxels_.resize(merged);
}

double VoxelSample::shareHolding(std::uint32_t count) const {
  const auto holding =
      std::count_if(voxels_.begin(), voxels_.end(), [count](const Voxel& voxel) { return voxel.count >= count; });
  return static_cast<double>(holding) / static_cast<double>(std::max<std::size_t>(1, size()));
}

double VoxelSample::shareAlone(double edge) const {
  if (alone_.empty()) return 0.0;
  const double doublings = std::clamp(std::round(portable::log2(edge / finest_)), 0.0, double(kMostDoublings));
  return alone_[static_cast<std::size_t>(doublings)];
}

double VoxelSample::edgeWithAlone(double share) const {
  double edge = finest_;
  for (std::size_t level = 0; level < alone_.size() && alone_[level] > share; ++level) edge *= 2.0;
  return edge;
}

Points VoxelSample::points(std::uint32_t count) const {
  Points result;
  result.reserve(size());
  for (const Voxel& voxel : voxels_) {
    if (voxel.count >= count) result.push_back(voxel.point);
  }
  return result;
}

}  // namespace tank_datum
