#include "fit/circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum::circle_test {

using Plan = std::vector<Eigen::Vector2d>;
const Eigen::Vector2d kCenter(3.0, -4.0);

/// Points of a circle over an arc [rad], with normal errors along the radius.
Plan arcOf(const Circle& circle, std::size_t count, double arc, double noise = 0.0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0.0, 1.0);
  Plan points;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = arc * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(circle.center +
                     (circle.radius + noise * error(random)) * Eigen::Vector2d(std::cos(a), std::sin(a)));
  }
  return points;
}

void expectCircle(const Circle& circle, const Circle& expected, double tolerance) {
  ASSERT_TRUE(circle.valid());
  EXPECT_NEAR(circle.center.x(), expected.center.x(), tolerance);
  EXPECT_NEAR(circle.center.y(), expected.center.y(), tolerance);
  EXPECT_NEAR(circle.radius, expected.radius, tolerance);
}

TEST(Circle, IsNotValidUntilFitted) {
  EXPECT_FALSE(Circle().valid());
  EXPECT_TRUE((Circle{{0, 0}, 1}).valid());
  EXPECT_FALSE((Circle{{0, 0}, 0}).valid());
  EXPECT_FALSE((Circle{{NAN, 0}, 1}).valid());
}

TEST(Circle, ResidualIsPositiveOutside) {
  const Circle circle{{1, 1}, 5};
  EXPECT_DOUBLE_EQ(circle.residual({4, 5}), 0.0);
  EXPECT_DOUBLE_EQ(circle.residual({1, 8}), 2.0);
  EXPECT_DOUBLE_EQ(circle.residual({1, 1}), -5.0);
}

TEST(CircleThrough, ThreePointsOfAKnownCircle) {
  expectCircle(circleThrough({1, 0}, {0, 1}, {-1, 0}), {{0, 0}, 1}, 1e-15);
  expectCircle(circleThrough({8, -4}, {3, 1}, {0, 0}), {kCenter, 5}, 1e-12);  // (0, 0): 3-4-5
}

TEST(CircleThrough, CollinearOrEqualPointsHaveNone) {
  EXPECT_FALSE(circleThrough({0, 0}, {1, 1}, {3, 3}).valid());
  EXPECT_FALSE(circleThrough({0, 0}, {0.1, 0.3}, {0.7, 2.1}).valid());  // to within rounding
  EXPECT_FALSE(circleThrough({1e6, 0}, {1e6 + 1, 0}, {1e6 + 7, 0}).valid());
  EXPECT_FALSE(circleThrough({1, 2}, {1, 2}, {3, 3}).valid());
  EXPECT_FALSE(circleThrough({1, 2}, {1, 2}, {1, 2}).valid());
}

TEST(FitCircle, FindsTheExactCircleFromAPoorStart) {
  const Circle truth{kCenter, 5};
  expectCircle(fitCircle(arcOf(truth, 7, 6.28), {}, {{1, -2}, 3}), truth, 1e-9);
}

TEST(FitCircle, KeepsItsAccuracyAtNationalCoordinates) {
  const Circle truth{{512034.25, 4012877.5}, 30};
  expectCircle(fitCircle(arcOf(truth, 400, 3.1), {}, {{512030, 4012880}, 25}), truth, 1e-6);
}

TEST(FitCircle, LeavesOutPointsOfNoWeight) {
  const Circle truth{kCenter, 5};
  Plan points = arcOf(truth, 8, 6.0);
  points.emplace_back(9, 1);
  std::vector<double> weights(9, 1.0);
  EXPECT_GT(std::abs(fitCircle(points, weights, truth).radius - 5), 0.1);
  weights[8] = 0.0;
  expectCircle(fitCircle(points, weights, truth), truth, 1e-9);
}

TEST(FitCircle, AveragesNormalErrors) {
  const Circle truth{kCenter, 30};
  const Circle fit = fitCircle(arcOf(truth, 10'000, 6.283, 0.003), {}, {kCenter, 29});
  expectCircle(fit, truth, 5 * 0.003 * std::sqrt(2.0 / 10'000));
}

TEST(FitCircle, TellsWhenPointsDetermineNone) {
  EXPECT_FALSE(fitCircle({}, {}, {{0, 0}, 1}).valid());
  EXPECT_FALSE(fitCircle({{1, 0}, {0, 1}}, {}, {{0, 0}, 1}).valid());
  EXPECT_FALSE(fitCircle(arcOf({kCenter, 5}, 8, 6.0), {}, Circle()).valid());
  Plan line;
  for (int i = 0; i < 20; ++i) line.emplace_back(i, 0.0);
  EXPECT_FALSE(fitCircle(line, {}, {{10, 5}, 11}).valid());
}

TEST(FitCircleRobust, IsNotMovedByGrossErrors) {
  const Circle truth{kCenter, 5};
  Plan points = arcOf(truth, 100, 6.28, 0.001);
  for (int i = 0; i < 30; ++i) points.emplace_back(3.0 + 0.02 * i, 2.0);  // all on one side, 1 m outside
  const Circle plain = fitCircle(points, {}, truth), robust = fitCircleRobust(points, truth);
  EXPECT_GT((plain.center - kCenter).norm(), 0.05);
  expectCircle(robust, truth, 0.001);
}

TEST(FitCircleRobust, TakesPointsWithoutAnyError) {
  const Circle truth{kCenter, 5};
  expectCircle(fitCircleRobust(arcOf(truth, 12, 6.28), truth), truth, 1e-12);
  expectCircle(fitCircleRobust(arcOf(truth, 12, 6.28), {{3.1, -4.1}, 5.2}), truth, 1e-6);
}

TEST(FitCircleRobust, TellsWhenPointsDetermineNone) {
  EXPECT_FALSE(fitCircleRobust({}, {{0, 0}, 1}).valid());
  EXPECT_FALSE(fitCircleRobust({{1, 0}, {0, 1}}, {{0, 0}, 1}).valid());
  EXPECT_FALSE(fitCircleRobust(arcOf({kCenter, 5}, 8, 6.0), Circle()).valid());
}

TEST(FindCircle, FindsACircleAmongFortyPercentClutter) {
  const Circle truth{kCenter, 30};
  Plan points = arcOf(truth, 600, 6.28, 0.003);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-40, 40);
  for (int i = 0; i < 400; ++i) points.push_back(kCenter + Eigen::Vector2d(place(random), place(random)));
  expectCircle(findCircle(points, 0.05), truth, 0.003);
}

TEST(FindCircle, ItsToleranceDecidesWhatBelongsToTheCircle) {
  const Circle narrow{kCenter, 10}, wide{kCenter, 10.5};
  Plan points = arcOf(narrow, 300, 6.28);
  for (const auto& p : arcOf(wide, 200, 6.28)) points.push_back(p);
  expectCircle(findCircle(points, 0.05), narrow, 1e-6);
  const Circle both = findCircle(points, 2.0);
  EXPECT_GT(both.radius, 10.05);
  EXPECT_LT(both.radius, 10.45);
}

TEST(FindCircle, GivesTheSameCircleEachTime) {
  const Plan points = arcOf({kCenter, 30}, 500, 4.0, 0.01);
  const Circle once = findCircle(points, 0.05), twice = findCircle(points, 0.05);
  EXPECT_EQ(once.center, twice.center);
  EXPECT_EQ(once.radius, twice.radius);
}

TEST(FindCircle, TellsWhenThereIsNone) {
  EXPECT_FALSE(findCircle({}, 0.1).valid());
  EXPECT_FALSE(findCircle({{0, 0}, {1, 0}}, 0.1).valid());
  Plan line;
  for (int i = 0; i < 50; ++i) line.emplace_back(i, 2.0 * i);
  EXPECT_FALSE(findCircle(line, 0.1).valid());
}

/// 3 points of 10 among 100 are drawn with a probability of 0.00072, so 2000 draws find the circle in 76 of 100 scenes.
TEST(FindCircle, DrawsTwoThousandTimes) {
  const Circle truth{kCenter, 10};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-20, 20);
  int found = 0;
  for (int scene = 0; scene < 100; ++scene) {
    Plan points = arcOf(truth, 10, 6.28);
    while (points.size() < 100) points.push_back(kCenter + Eigen::Vector2d(place(random), place(random)));
    for (std::size_t i = points.size(); i-- > 1;) std::swap(points[i], points[random() % (i + 1)]);
    const Circle circle = findCircle(points, 1e-3);
    found += (circle.center - truth.center).norm() < 1e-3 && std::abs(circle.radius - truth.radius) < 1e-3;
  }
  EXPECT_NEAR(found, 76, 12);  // of 1000 draws 51, of 4000 draws 94
}

}  // namespace tank_datum::circle_test
