#include <limits>

#include "core/parallel.h"
#include "search/bucket_kernels.h"
#include "search/bucket_tree.h"
#include "search/bucket_walk.h"

namespace tank_datum {

constexpr float kRoom = 1.4F;  // times the squared distance of the k-th neighbour before, the next one's is expected

/// What one thread needs for the points of a bucket; allocated once.
struct BucketTree::Batch {
  std::vector<float> x, y, z;  // of the points around the bucket
  std::vector<std::uint32_t> numbers;
  std::size_t size = 0;
  float squared_reach = -1.0F;  // from the bucket's box, within which there are all
  float furthest = 0.0F;        // squared, of the neighbours of the bucket before
  std::vector<std::int32_t> hit_squared;
  std::vector<std::uint32_t> hit_numbers;
  std::vector<FoundPoint> row;  // of the last point, nearest first

  void reserve(std::size_t points) {
    if (padded(points) <= x.size()) return;
    const std::size_t room = 2 * padded(points);
    for (auto* column : {&x, &y, &z}) column->resize(room);
    for (auto* column : {&numbers, &hit_numbers}) column->resize(room);
    hit_squared.resize(room);
  }
  float kthSquared() const { return squaredDistanceOf(row.back()); }
};

/// Copies the points of every bucket whose box is within reach of this bucket's; none where there are too many, for
/// points that lie so unevenly are better looked for one by one.
void BucketTree::gather(std::size_t bucket, float squared_reach, Batch& batch) const {
  constexpr std::size_t kLargest = 4096;
  batch.size = 0;
  batch.squared_reach = std::max(squared_reach, std::numeric_limits<float>::min());  // k points in one place
  forEachBucket(boxOf(depth_, bucket), batch.squared_reach, [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    batch.reserve(batch.size + count);
    std::copy_n(&x_[begin], count, &batch.x[batch.size]);
    std::copy_n(&y_[begin], count, &batch.y[batch.size]);
    std::copy_n(&z_[begin], count, &batch.z[batch.size]);
    std::copy_n(&ids_[begin], count, &batch.numbers[batch.size]);
    batch.size += count;
    if (batch.size > kLargest) batch.squared_reach = -1.0F;  // ends the walk
  });
}

/// The row of a place in the batch's bucket, if its k nearest are surely in the batch. How far they are is guessed from
/// the last row; a guess that meets k points needs no other proof.
bool BucketTree::nearestInBatch(const Eigen::Vector3f& place, std::size_t k, Batch& batch) const {
  if (batch.squared_reach < 0.0F) return false;
  const PointColumns points{batch.x.data(), batch.y.data(), batch.z.data(), batch.numbers.data(), batch.size};
  const HitColumns hits{batch.hit_squared.data(), batch.hit_numbers.data()};
  float limit = std::max(kRoom * batch.kthSquared(), std::numeric_limits<float>::min());
  for (;; limit *= 2.0F) {
    limit = std::min(limit, batch.squared_reach);
    const std::size_t count = keepWithin(points, place.data(), limit, hits);
    if (count >= k) {
      sortNearest(hits, count, k, batch.row.data());
      return true;
    }
    if (limit >= batch.squared_reach) return false;
  }
}

/// Its points' neighbours are about as far as those of the bucket before; where they are further, one of them is looked
/// for in the whole tree, and says how far.
void BucketTree::fillBucket(std::size_t bucket, std::size_t k, std::int32_t* rows, Batch& batch) const {
  const std::size_t begin = firstOf(depth_, bucket), end = firstOf(depth_, bucket + 1);
  if (batch.row.size() == k) gather(bucket, kRoom * batch.furthest, batch);
  batch.furthest = 0.0F;
  bool crowded = false;
  for (std::size_t i = begin; i < end; ++i) {
    const Eigen::Vector3f place(x_[i], y_[i], z_[i]);
    if (batch.row.size() != k || !nearestInBatch(place, k, batch)) {
      batch.row = nearest(place, k);
      if (!crowded) gather(bucket, kRoom * batch.kthSquared(), batch);
      crowded = batch.squared_reach < 0.0F;
    }
    batch.furthest = std::max(batch.furthest, batch.kthSquared());
    std::int32_t* row = rows + static_cast<std::size_t>(ids_[i]) * k;
    for (std::size_t j = 0; j < k; ++j) row[j] = numberOf(batch.row[j]);
  }
}

void BucketTree::nearestOfAll(std::size_t k, int threads, std::int32_t* rows, const RowsDone& done) const {
  if (size() == 0 || k == 0) return;
  constexpr std::size_t kAtOnce = 64;  // buckets that share their scratch space
  forEachIndex((buckets() + kAtOnce - 1) / kAtOnce, threads, [&](std::size_t part) {
    Batch batch;
    for (std::size_t bucket = part * kAtOnce; bucket < std::min(buckets(), (part + 1) * kAtOnce); ++bucket) {
      fillBucket(bucket, k, rows, batch);
      const std::size_t begin = firstOf(depth_, bucket);
      if (done) done(&ids_[begin], firstOf(depth_, bucket + 1) - begin);
    }
  });
}

}  // namespace tank_datum
