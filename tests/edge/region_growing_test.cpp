#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/units.h"
#include "support/refused.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::region_growing_test {

using Indices = std::vector<std::int32_t>;

GrowingOptions above(double degrees) {
  GrowingOptions options;
  options.angle = degrees * kDegree;
  return options;
}

Eigen::Vector3f tilted(double degrees) {
  return Eigen::Vector3d(0, -std::sin(degrees * kDegree), std::cos(degrees * kDegree)).cast<float>();
}

/// Two half planes that meet along the x axis; the one at y > 0 rises by `degrees`. Places at random, so that no two
/// distances are equal.
Points fold(double degrees, std::size_t count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1.0, 1.0);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = place(random), v = place(random), turn = v > 0 ? degrees * kDegree : 0.0;
    points.emplace_back(x, v * std::cos(turn), v * std::sin(turn));
  }
  return points;
}

NormalOptions withK(int k) {
  NormalOptions options;
  options.k = k;
  return options;
}

TEST(GrowCandidates, MarksTwoPointsExactlyWhenThetaIsBelowTheirAngle) {
  const Normals pair{2, {0, 1, 1, 0}, {tilted(0), tilted(40)}};
  EXPECT_EQ(growCandidates(pair, above(39.9)), (Indices{0, 1}));
  EXPECT_EQ(growCandidates(pair, above(40.1)), Indices());
}

TEST(GrowCandidates, TakesNormalsWithoutTheirSign) {
  EXPECT_EQ(growCandidates({2, {0, 1, 1, 0}, {tilted(0), -tilted(40)}}, above(40.1)), Indices());
  EXPECT_EQ(growCandidates({2, {0, 1, 1, 0}, {tilted(0), -tilted(40)}}, above(39.9)), (Indices{0, 1}));
  EXPECT_EQ(growCandidates({2, {0, 1, 1, 0}, {tilted(0), tilted(180)}}, above(1)), Indices());
}

TEST(GrowCandidates, MarksTheNeighbourAndNotTheSeed) {
  // the first point sees the second, which sees only itself and the third
  const Normals chain{2, {0, 1, 1, 2, 2, 1}, {tilted(40), tilted(0), tilted(0)}};
  EXPECT_EQ(growCandidates(chain, above(30)), Indices{1});
}

TEST(GrowCandidates, APointTakenIsASeedStill) {
  // in the paper the first point takes the second, which then takes nobody
  const Normals chain{2, {0, 1, 1, 2, 2, 2}, {tilted(0), tilted(40), tilted(0)}};
  EXPECT_EQ(growCandidates(chain, above(30)), (Indices{1, 2}));
}

TEST(GrowCandidates, OfAnEmptyCloudAreNone) { EXPECT_TRUE(growCandidates({20, {}, {}}, above(30)).empty()); }

TEST(GrowCandidates, OfAPlaneAreNone) {
  EXPECT_TRUE(growCandidates(estimateNormals(fold(0, 500), withK(10)), above(1)).empty());
}

TEST(GrowCandidates, OfTwoHalfPlanesLieAtTheirCreaseWhenThetaIsBelowItsAngle) {
  const Points points = fold(60, 3000);
  const Normals normals = estimateNormals(points, withK(15));
  const Indices marked = growCandidates(normals, above(20));
  EXPECT_GT(marked.size(), 100U);
  std::size_t near_crease = 0;
  for (const auto& p : points) near_crease += std::abs(p.y()) < 0.01;
  std::size_t near_marked = 0;
  for (const auto i : marked) {
    const auto& p = points[static_cast<std::size_t>(i)];
    EXPECT_LT(std::hypot(p.y(), p.z()), 0.25) << i;  // twice the reach of 15 neighbours at 750 points per m2
    near_marked += std::abs(p.y()) < 0.01;
  }
  EXPECT_GT(near_marked, near_crease * 9 / 10);
  EXPECT_TRUE(growCandidates(normals, above(61)).empty());
}

TEST(GrowCandidates, AWiderThetaMarksFewer) {
  const Normals normals = estimateNormals(fold(60, 3000), withK(15));
  const auto count = [&](double degrees) { return growCandidates(normals, above(degrees)).size(); };
  EXPECT_GT(count(10), count(30));
  EXPECT_GT(count(30), count(50));
}

TEST(GrowCandidates, DoNotDependOnTheOrderOfThePoints) {
  const Points points = fold(60, 2000);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  Points shuffled;
  for (const std::size_t i : order) shuffled.push_back(points[i]);
  Indices back;
  for (const auto i : growCandidates(estimateNormals(shuffled, withK(15)), above(30))) {
    back.push_back(static_cast<std::int32_t>(order[static_cast<std::size_t>(i)]));
  }
  std::sort(back.begin(), back.end());
  EXPECT_EQ(back, growCandidates(estimateNormals(points, withK(15)), above(30)));
}

/// Neighbours and normals without any geometry behind them.
Normals randomGraph(std::size_t count, int k) {
  std::mt19937 random(9);
  std::normal_distribution<float> component;
  Normals graph;
  graph.k = k;
  for (std::size_t i = 0; i < count; ++i) {
    graph.normals.push_back(
        Eigen::Vector3f(0.3F * component(random), 0.3F * component(random), component(random)).normalized());
    for (int j = 0; j < k; ++j) graph.neighbours.push_back(static_cast<std::int32_t>(random() % count));
  }
  return graph;
}

TEST(GrowCandidates, AgreeWithThePapersFormulaTakenPairByPair) {
  const Normals graph = randomGraph(500, 4);
  for (const double degrees : {10.0, 45.0, 80.0}) {
    Indices expected;
    for (std::int32_t i = 0; i < 500; ++i) {
      bool marked = false;
      for (std::size_t j = 0; j < graph.neighbours.size(); ++j) {
        const Eigen::Vector3d a = graph.normals[j / 4].cast<double>();
        const Eigen::Vector3d b = graph.normals[static_cast<std::size_t>(i)].cast<double>();
        marked |= graph.neighbours[j] == i && std::acos(std::min(1.0, std::abs(a.dot(b)))) > degrees * kDegree;
      }
      if (marked) expected.push_back(i);
    }
    EXPECT_EQ(growCandidates(graph, above(degrees)), expected) << degrees;
    EXPECT_FALSE(expected.empty());
  }
}

TEST(GrowCandidates, DoNotDependOnTheNumberOfThreads) {
  const Normals graph = randomGraph(3000, 5);
  const Indices one = growCandidates(graph, above(60), 1);
  EXPECT_GT(one.size(), 100U);
  EXPECT_LT(one.size(), 2900U);
  for (const int threads : {2, 4, 0}) EXPECT_EQ(growCandidates(graph, above(60), threads), one) << threads;
}

TEST(GrowingOptions, RefuseAnAngleThatIsNotAcuteByName) {
  EXPECT_EQ(said(firstError(GrowingOptions())), "");
  EXPECT_EQ(said(firstError(above(89))), "");
  EXPECT_EQ(said(firstError(above(0))), "angle_deg, 0, expected > 0 and < 90 deg");
  EXPECT_EQ(said(firstError(above(90))), "angle_deg, 90, expected > 0 and < 90 deg");
  EXPECT_NE(said(firstError(above(-1))), "");
  EXPECT_NE(said(firstError(above(NAN))), "");
}

}  // namespace tank_datum::region_growing_test
