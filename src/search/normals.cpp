#include "core/parallel.h"
#include "core/refusal.h"
#include "fit/plane_normal.h"
#include "search/bucket_tree.h"
#include "search/pcl_normals.h"
#include "tank_datum/core/error.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum {
namespace {

/// Sums relative to the point: of coordinates far from the origin little would be left.
Eigen::Vector3f normalOf(const Points& points, std::size_t i, const std::int32_t* neighbours, int k) {
  const Eigen::Vector3d& own = points[i];
  double x = 0, y = 0, z = 0;
  SymmetricMatrix squares;
  for (int j = 0; j < k; ++j) {
    const Eigen::Vector3d& p = points[static_cast<std::size_t>(neighbours[j])];
    const double dx = p.x() - own.x(), dy = p.y() - own.y(), dz = p.z() - own.z();
    x += dx, y += dy, z += dz;
    squares.xx += dx * dx, squares.xy += dx * dy, squares.xz += dx * dz;
    squares.yy += dy * dy, squares.yz += dy * dz, squares.zz += dz * dz;
  }
  const double share = 1.0 / k;
  squares.xx -= x * x * share, squares.xy -= x * y * share, squares.xz -= x * z * share;
  squares.yy -= y * y * share, squares.yz -= y * z * share, squares.zz -= z * z * share;
  return planeNormal(squares).cast<float>();
}

Normals withRoom(std::size_t points, int k) {
  Normals normals;
  normals.k = k;
  normals.neighbours.resize(points * static_cast<std::size_t>(k));
  normals.normals.resize(points);
  return normals;
}

/// Neighbours among the points rounded to float32, as PCL's; the sums of the normals in double.
Normals estimateNormalsWithBuckets(const Points& points, int k, int threads) {
  const auto width = static_cast<std::size_t>(k);
  Normals result = withRoom(points.size(), k);
  std::vector<Eigen::Vector3f> rounded(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) rounded[i] = points[i].cast<float>();
  const BucketTree tree(rounded, threads);
  // while its points are still in the cache
  tree.nearestOfAll(width, threads, result.neighbours.data(), [&](const std::uint32_t* found, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      result.normals[found[j]] = normalOf(points, found[j], &result.neighbours[found[j] * width], k);
    }
  });
  return result;
}

/// Both engines round to float32, of which squares of more are infinite.
void requireRoundable(const Points& points) {
  constexpr double kFarthest = 1e9;  // [m]
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double largest = points[i].cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    if (largest <= kFarthest) continue;
    throw Error(Error::Kind::Option, "normals", "row " + std::to_string(i) + " of points", generalText(largest),
                "coordinates that differ by 1e9 m at most");
  }
}

}  // namespace

const char* nameOf(SearchEngine engine) {
  switch (engine) {
    case SearchEngine::Flann:
      return "flann";
    case SearchEngine::Buckets:
      return "buckets";
  }
  return "";
}

Normals estimateNormals(const Points& points, const NormalOptions& options, int threads) {
  refuseFirst(firstError(options));
  const auto k = static_cast<std::size_t>(options.k);
  if (!points.empty() && points.size() < k) {
    throw Error(Error::Kind::Option, "normals", "k", std::to_string(options.k),
                "at most as many neighbours as points, " + std::to_string(points.size()));
  }
  if (points.empty()) return withRoom(0, options.k);
  requireRoundable(points);
  switch (options.search) {
    case SearchEngine::Flann:
      return estimateNormalsWithPcl(points, options.k, threads);
    case SearchEngine::Buckets:
      return estimateNormalsWithBuckets(points, options.k, threads);
  }
  return {};
}

Normals fitNormals(const Points& points, Neighbours neighbours, int k, int threads) {
  if (k < 1 || neighbours.size() != points.size() * static_cast<std::size_t>(k)) {
    throw Error(
        Error::Kind::Option, "normals", "k", std::to_string(k),
        "the length of the rows of neighbours, of which there are as many as points, " + std::to_string(points.size()));
  }
  Normals result;
  result.k = k;
  result.neighbours = std::move(neighbours);
  result.normals.resize(points.size());
  forEachRun(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result.normals[i] = normalOf(points, i, &result.neighbours[i * static_cast<std::size_t>(k)], k);
    }
  });
  return result;
}

}  // namespace tank_datum
