#include "locate/arc_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/approx_azimuth.h"
#include "core/units.h"

namespace tank_datum::arc_meter_test {

constexpr StandingRule kRule{0.3, 0.94};
constexpr double kBin = 0.5;

WallCell wall(const Eigen::Vector2d& position, double normal) {
  WallCell cell;
  cell.position = position;
  cell.normal = {std::cos(normal), std::sin(normal)};
  return cell;
}

/// Walls on a circle, facing its centre.
std::vector<WallCell> ring(const Circle& circle, double from, double to, int count) {
  std::vector<WallCell> walls;
  for (int i = 0; i < count; ++i) {
    const double azimuth = from + (to - from) * (i + 0.5) / count;
    const Eigen::Vector2d outwards(std::cos(azimuth), std::sin(azimuth));
    walls.push_back(wall(circle.center + circle.radius * outwards, azimuth));
  }
  return walls;
}

double seenArc(const std::vector<WallCell>& walls, const Circle& circle) {
  std::vector<const WallCell*> pointers;
  for (const WallCell& w : walls) pointers.push_back(&w);
  return ArcMeter(pointers).seen(circle, kRule, kBin);
}

const Circle kCircle{{3.0, -4.0}, 5.0};

TEST(ArcMeter, OfAWholeCircleIsAFullTurnAndOfNoneNothing) {
  EXPECT_EQ(seenArc(ring(kCircle, 0.0, kTwoPi, 400), kCircle), kTwoPi);
  EXPECT_EQ(seenArc({}, kCircle), 0.0);
  EXPECT_EQ(seenArc(ring({{40.0, 0.0}, 5.0}, 0.0, kTwoPi, 400), kCircle), 0.0);
}

TEST(ArcMeter, OfAnArcIsItsLengthToABin) {
  EXPECT_NEAR(seenArc(ring(kCircle, 1.0, 3.0, 301), kCircle), 2.0, 2.0 * kBin / kCircle.radius);
  EXPECT_NEAR(seenArc(ring(kCircle, -0.5, 0.5, 302), kCircle), 1.0, 2.0 * kBin / kCircle.radius);
}

TEST(ArcMeter, AWallSeenEdgeOnDoesNotCount) {
  const Eigen::Vector2d place = kCircle.center + Eigen::Vector2d(0.0, 5.0);
  EXPECT_GT(seenArc({wall(place, 0.5 * kPi)}, kCircle), 0.0);
  EXPECT_GT(seenArc({wall(place, -0.5 * kPi)}, kCircle), 0.0);
  EXPECT_EQ(seenArc({wall(place, 0.0)}, kCircle), 0.0);
}

/// One by one, by the rule and the direction as they are written.
TEST(ArcMeter, IsWhatTheRuleSaysOfEachWall) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-6.0, 6.0), turn(0.0, kTwoPi);
  for (const int count : {1, 2, 3, 4, 5, 7, 1000}) {
    std::vector<WallCell> walls;
    for (int i = 0; i < count; ++i) {
      walls.push_back(wall(kCircle.center + Eigen::Vector2d(place(random), place(random)), turn(random)));
    }
    const double bins = std::floor(kTwoPi * kCircle.radius / kBin);
    std::set<int> seen;
    for (const WallCell& w : walls) {
      const Eigen::Vector2d arm = w.position - kCircle.center;
      if (kRule.holds(w, kCircle)) seen.insert(static_cast<int>(approxTurn(arm.x(), arm.y()) * bins));
    }
    EXPECT_DOUBLE_EQ(seenArc(walls, kCircle), kTwoPi * static_cast<double>(seen.size()) / bins) << count;
  }
}

}  // namespace tank_datum::arc_meter_test
