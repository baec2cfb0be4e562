#include <gtest/gtest.h>
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "support/refused.h"
#include "tank_datum/core/error.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::normals_test {

NormalOptions withK(int k) {
  NormalOptions options;
  options.k = k;
  options.search = SearchEngine::Buckets;  // sums in double: to be held to known answers
  return options;
}

/// Acute angle between two unsigned directions [rad].
double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// A curved surface with noise, like a piece of shell on its pad.
Points wavySurface(std::size_t count, double noise, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::normal_distribution<double> error(0.0, 1.0);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = place(random), y = place(random);
    points.emplace_back(x, y, 0.2 * std::sin(3 * x) + 0.3 * y * y + noise * error(random));
  }
  return points;
}

void expectNormal(const Points& points, const Eigen::Vector3d& expected) {
  const Normals result = estimateNormals(points, withK(static_cast<int>(points.size())));
  ASSERT_EQ(result.size(), points.size());
  for (const auto& n : result.normals) EXPECT_LT(angleBetween(n.cast<double>(), expected.normalized()), 1e-6);
}

TEST(Normals, OfFourPointsOfThePlanesXyzAndXEqualsZ) {
  expectNormal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0, 0, 1});
  expectNormal({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}}, {0, 1, 0});
  expectNormal({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}}, {1, 0, 0});
  expectNormal({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {1, 1, 1}}, {-1, 0, 1});
}

TEST(Normals, OfASaddleOfFourPointsIsItsAxis) {
  expectNormal({{1, 0, .2}, {-1, 0, .2}, {0, 1, -.2}, {0, -1, -.2}}, {0, 0, 1});
}

TEST(Normals, AreOfUnitLengthAndAcrossALineOrASinglePlace) {
  const Normals line = estimateNormals({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, withK(4));
  for (const auto& n : line.normals) {
    EXPECT_NEAR(n.norm(), 1.0, 1e-6);
    EXPECT_NEAR(n.dot(Eigen::Vector3f(1, 1, 0)), 0.0, 1e-6);
  }
  for (const auto& n : estimateNormals(Points(5, {1, 2, 3}), withK(3)).normals) EXPECT_NEAR(n.norm(), 1.0, 1e-6);
}

TEST(Normals, OfAnEmptyCloudAreNone) {
  const Normals result = estimateNormals({}, NormalOptions());
  EXPECT_EQ(result.size(), 0U);
  EXPECT_TRUE(result.neighbours.empty());
}

TEST(Normals, OfANoisyPlaneScatterAboutItsNormal) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::normal_distribution<double> error(0.0, 0.002);
  const Eigen::Vector3d u = Eigen::Vector3d(1, 0, 0.5).normalized(), v(0, 1, 0), normal = u.cross(v);
  Points points;
  for (int i = 0; i < 2000; ++i) points.push_back(place(random) * u + place(random) * v + error(random) * normal);
  double squares = 0;
  for (const auto& n : estimateNormals(points, withK(20)).normals) {
    squares += std::pow(angleBetween(n.cast<double>(), normal), 2) / 2000;
  }
  // 20 neighbours lie within 0.056 m, spread 0.028 m: 0.002 / (0.028 sqrt 20) rad in each of two directions
  EXPECT_NEAR(std::sqrt(squares), 0.0226, 0.006);
}

TEST(Normals, AgreeWithPclNormalEstimation) {
  const Points points = wavySurface(3000, 0.003);
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : points) cloud->push_back(pcl::PointXYZ(float(p.x()), float(p.y()), float(p.z())));
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> oracle;
  oracle.setInputCloud(cloud);
  oracle.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  oracle.setKSearch(15);
  pcl::PointCloud<pcl::Normal> expected;
  oracle.compute(expected);
  const Normals result = estimateNormals(points, withK(15));
  NormalOptions by_default;
  by_default.k = 15;
  const Normals same = estimateNormals(points, by_default);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(same.normals[i].cwiseAbs(), expected[i].getNormalVector3fMap().cwiseAbs()) << i;
    const Eigen::Vector3d theirs = expected[i].getNormalVector3fMap().cast<double>();
    EXPECT_LT(angleBetween(result.normals[i].cast<double>(), theirs), 2e-3) << i;  // theirs is summed in float
  }
}

TEST(Normals, NeighboursAreThoseOfABruteForceSearchNearestFirst) {
  const Points points = wavySurface(400, 0.01);
  const Normals result = estimateNormals(points, withK(12));
  ASSERT_EQ(result.neighbours.size(), 400U * 12U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> distances;
    for (const auto& p : points) distances.push_back((p - points[i]).norm());
    std::sort(distances.begin(), distances.end());
    EXPECT_EQ(result.neighbours[12 * i], static_cast<std::int32_t>(i));
    for (std::size_t j = 0; j < 12; ++j) {
      const auto neighbour = static_cast<std::size_t>(result.neighbours[12 * i + j]);
      EXPECT_NEAR((points[neighbour] - points[i]).norm(), distances[j], 1e-6) << i << " " << j;
    }
  }
}

TEST(Normals, WithAsManyNeighboursAsPointsAreTheSameEverywhere) {
  const Points points = wavySurface(30, 0.01);
  const Normals result = estimateNormals(points, withK(30));
  for (std::size_t i = 0; i < 30; ++i) {
    std::vector<std::int32_t> row(result.neighbours.begin() + std::ptrdiff_t(30 * i),
                                  result.neighbours.begin() + std::ptrdiff_t(30 * (i + 1)));
    std::vector<std::int32_t> all(30);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_TRUE(std::is_permutation(row.begin(), row.end(), all.begin()));
    EXPECT_LT(angleBetween(result.normals[i].cast<double>(), result.normals[0].cast<double>()), 1e-6);
  }
}

TEST(Normals, MoreNeighboursSmoothTheNoise) {
  const Points points = wavySurface(4000, 0.004);
  const auto roughness = [&](int k) {
    double sum = 0;
    const Normals result = estimateNormals(points, withK(k));
    EXPECT_EQ(result.k, k);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d truth(-0.6 * std::cos(3 * points[i].x()), -0.6 * points[i].y(), 1.0);
      sum += angleBetween(result.normals[i].cast<double>(), truth);
    }
    return sum;
  };
  EXPECT_LT(roughness(30), 0.5 * roughness(8));
}

TEST(Normals, DoNotDependOnTheNumberOfThreads) {
  const Points points = wavySurface(2500, 0.003);
  const Normals one = estimateNormals(points, withK(20), 1);
  for (const int threads : {2, 4, 0}) {
    const Normals more = estimateNormals(points, withK(20), threads);
    EXPECT_EQ(more.neighbours, one.neighbours) << threads;
    EXPECT_TRUE(more.normals == one.normals) << threads;
  }
}

TEST(Normals, KeepTheirAccuracyAKilometreFromTheOrigin) {
  const Points near = wavySurface(2000, 0.001);
  const Eigen::Vector3d shift(1000.25, -1000.5, 500.125);
  Points far = near;
  for (auto& p : far) p += shift;
  const Normals at_origin = estimateNormals(near, withK(20)), moved = estimateNormals(far, withK(20));
  std::size_t other = 0;  // float32 there has steps of 0.06 mm: now and then it takes another of two equally far points
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double angle = angleBetween(at_origin.normals[i].cast<double>(), moved.normals[i].cast<double>());
    other += angle > 1e-6;
    EXPECT_LT(angle, 0.02) << i;
  }
  EXPECT_LT(other, near.size() / 50);
}

TEST(NormalOptions, RefuseFewerThanThreeNeighboursByName) {
  EXPECT_EQ(said(firstError(NormalOptions())), "");
  EXPECT_EQ(said(firstError(withK(3))), "");
  EXPECT_EQ(said(firstError(withK(2))), "k, 2, expected >= 3");
  EXPECT_EQ(said(firstError(withK(-5))), "k, -5, expected >= 3");
}

TEST(Normals, OfFewerPointsThanNeighboursAreRefused) {
  for (const SearchEngine engine : {SearchEngine::Flann, SearchEngine::Buckets}) {
    NormalOptions options = withK(20);
    options.search = engine;
    EXPECT_THROW(estimateNormals(Points(19, {1, 2, 3}), options), Error);
    EXPECT_EQ(estimateNormals(Points(20, {1, 2, 3}), options).size(), 20U);
  }
}

TEST(NormalOptions, TheSearchEngineHasAName) {
  EXPECT_STREQ(nameOf(SearchEngine::Flann), "flann");
  EXPECT_STREQ(nameOf(SearchEngine::Buckets), "buckets");
}

/// Points in pairs at one place, the later one first in FLANN's tree as often as not.
TEST(Normals, AreTheSameByBothEnginesButForThoseEquallyFar) {
  NormalOptions flann = withK(20), buckets = withK(20);
  flann.search = SearchEngine::Flann;
  buckets.search = SearchEngine::Buckets;
  Points points = wavySurface(20000, 0.001);
  const Normals by_flann = estimateNormals(points, flann), by_buckets = estimateNormals(points, buckets);
  EXPECT_EQ(by_flann.neighbours, by_buckets.neighbours);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d theirs = by_flann.normals[i].cast<double>();  // summed in float
    EXPECT_LT(angleBetween(by_buckets.normals[i].cast<double>(), theirs), 2e-3) << i;
  }

  points.resize(200);
  const Points once = points;
  points.insert(points.end(), once.begin(), once.end());
  const Normals doubled = estimateNormals(points, buckets);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(doubled.neighbours[20 * i], static_cast<std::int32_t>(i % 200));
    EXPECT_EQ(doubled.neighbours[20 * i + 1], static_cast<std::int32_t>(i % 200 + 200));
  }
  EXPECT_NE(estimateNormals(points, flann).neighbours, doubled.neighbours);
}

TEST(FitNormals, OfTheSameNeighboursAreTheSame) {
  const Points points = wavySurface(500, 0.001);
  const Normals both = estimateNormals(points, withK(12));
  for (const int threads : {1, 2}) {
    const Normals fitted = fitNormals(points, both.neighbours, 12, threads);
    EXPECT_EQ(fitted.k, 12);
    EXPECT_EQ(fitted.neighbours, both.neighbours);
    EXPECT_EQ(fitted.normals, both.normals);
  }
}

TEST(FitNormals, GoByTheNeighboursGiven) {
  const Points points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Normals fitted = fitNormals(points, {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3}, 3);
  const Eigen::Vector3d expected[] = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(angleBetween(fitted.normals[i].cast<double>(), expected[i]), 1e-6) << i;
  }
}

}  // namespace tank_datum::normals_test
