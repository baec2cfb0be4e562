#include "tank_datum/search/normals.h"

#include "fit/plane_normal.h"
#include "search/neighbour_rows.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/parallel.h"

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

std::string firstError(const NormalOptions& options) {
  if (options.k < 3) return "normals.k = " + std::to_string(options.k) + " (must be >= 3)";
  return {};
}

Normals estimateNormals(const Points& points, const NormalOptions& options, int threads) {
  const auto k = static_cast<std::size_t>(options.k);
  Normals result;
  result.k = options.k;
  result.neighbours.resize(points.size() * k);
  result.normals.resize(points.size());
  if (points.empty()) return result;
  if (points.size() < k) {
    throw Error(Error::Kind::Option, "normals", "k", std::to_string(options.k),
                "at most as many neighbours as points, " + std::to_string(points.size()));
  }

  const NeighbourRows rows{options.k, threads, result.neighbours.data()};
  // while its points are still in the cache
  findRows(options.search, points, rows, [&](const std::uint32_t* found, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
      result.normals[found[j]] = normalOf(points, found[j], &result.neighbours[found[j] * k], options.k);
    }
  });
  return result;
}

Normals fitNormals(const Points& points, Neighbours neighbours, int k, int threads) {
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
