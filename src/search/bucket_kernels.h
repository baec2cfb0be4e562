#pragma once

#include <cstddef>
#include <cstdint>

/// The inner loops of BucketTree::nearestOfAll: plain arrays, compiled for AVX2 too, and chosen when the program
/// starts. No fused multiply-add: distances must be the same to the last bit on every machine.
namespace tank_datum {

constexpr std::size_t kLanes = 8;

/// The next whole number of lanes.
constexpr std::size_t padded(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

/// Points as columns, each with room for a padded number of them.
struct PointColumns {
  const float *x, *y, *z;
  const std::uint32_t* numbers;
  std::size_t count;
};

/// Points met, each with its squared distance as the bits of a float32, which sort as the distances do.
struct HitColumns {
  std::int32_t* squared;  ///< room for the padded number of points
  std::uint32_t* numbers;
};

/// Those at most so far from a place, by (dx dx + dy dy) + dz dz in float32.
/// @return how many
std::size_t keepWithin(const PointColumns& points, const float* place, float squared_limit, const HitColumns& hits);

/// The k nearest of the hits as FoundPoints, in order.
/// @param count  hits, at least k; their squared distances are padded here
void sortNearest(const HitColumns& hits, std::size_t count, std::size_t k, std::uint64_t* to);

}  // namespace tank_datum
