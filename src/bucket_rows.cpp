#include <omp.h>

#include <cmath>
#include <limits>

#include "bucket_kernels.h"
#include "bucket_walk.h"

namespace tank_datum {

/// What one thread needs for the points of a bucket; allocated once.
struct BucketTree::Batch {
  std::vector<float> x, y, z;  // of the points around the bucket
  std::vector<std::uint32_t> numbers;
  std::size_t size = 0;
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
};

/// Copies the points of every bucket whose box is within reach of this bucket's.
void BucketTree::gather(std::size_t bucket, double reach, Batch& batch) const {
  const auto squared = static_cast<float>(reach * reach * (1.0 + 1e-5));  // far above what rounding in float32 adds
  batch.size = 0;
  forEachBucket(boxOf(depth_, bucket), squared, [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    batch.reserve(batch.size + count);
    std::copy_n(&x_[begin], count, &batch.x[batch.size]);
    std::copy_n(&y_[begin], count, &batch.y[batch.size]);
    std::copy_n(&z_[begin], count, &batch.z[batch.size]);
    std::copy_n(&ids_[begin], count, &batch.numbers[batch.size]);
    batch.size += count;
  });
}

/// The row of a place whose k nearest are all in the batch. How far they are is guessed from the last row; a guess that
/// meets k points needs no other proof.
void BucketTree::nearestInBatch(const Eigen::Vector3f& place, std::size_t k, Batch& batch) const {
  constexpr float kRoom = 1.4F;  // times k are expected within
  const PointColumns points{batch.x.data(), batch.y.data(), batch.z.data(), batch.numbers.data(), batch.size};
  const HitColumns hits{batch.hit_squared.data(), batch.hit_numbers.data()};
  float limit = std::max(kRoom * squaredDistanceOf(batch.row.back()), std::numeric_limits<float>::min());
  std::size_t count = keepWithin(points, place.data(), limit, hits);
  while (count < k) {
    limit *= 2.0F;
    count = keepWithin(points, place.data(), limit, hits);
  }
  sortNearest(hits, count, k, batch.row.data());
}

void BucketTree::fillBucket(std::size_t bucket, std::size_t k, std::int32_t* rows, Batch& batch) const {
  constexpr std::size_t kLargest = 4096;  // where points lie so unevenly, each is looked for by itself
  const std::size_t begin = firstOf(depth_, bucket), end = firstOf(depth_, bucket + 1);
  const auto place = [&](std::size_t i) { return Eigen::Vector3f(x_[i], y_[i], z_[i]); };
  batch.row = nearest(place(begin), k);
  double reach = 0;  // no point of the bucket has its k nearest further away: those of the first are k
  for (std::size_t i = begin; i < end; ++i) {
    reach = std::max(reach, (place(i) - place(begin)).cast<double>().norm());
  }
  gather(bucket, reach + std::sqrt(static_cast<double>(squaredDistanceOf(batch.row.back()))), batch);
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && batch.size > kLargest) batch.row = nearest(place(i), k);
    if (i > begin && batch.size <= kLargest) nearestInBatch(place(i), k, batch);
    std::int32_t* row = rows + static_cast<std::size_t>(ids_[i]) * k;
    for (std::size_t j = 0; j < k; ++j) row[j] = numberOf(batch.row[j]);
  }
}

void BucketTree::nearestOfAll(std::size_t k, int threads, std::int32_t* rows, const RowsDone& done) const {
  if (size() == 0 || k == 0) return;
  const auto count = static_cast<std::ptrdiff_t>(buckets());
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_max_threads())
  {
    Batch batch;
#pragma omp for schedule(dynamic, 64)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const auto bucket = static_cast<std::size_t>(i);
      fillBucket(bucket, k, rows, batch);
      const std::size_t begin = firstOf(depth_, bucket);
      if (done) done(&ids_[begin], firstOf(depth_, bucket + 1) - begin);
    }
  }
}

}  // namespace tank_datum
