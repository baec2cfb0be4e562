#include "setups/setup_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"

namespace tank_datum::setup_views_test {

constexpr double kRadius = 30.0, kReach = 0.5;
constexpr double kArcLength = kTwoPi * kRadius / 144.0;  // of the arcs that are compared

Tank madeTank() {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return tank;
}

/// A ring of two setups, of which setup 0 alone sees the shell high up, all along the first arc.
class Overlap {
 public:
  Overlap() {
    ring_.reach = kReach;
    ring_.setups = {{0, 0}, {1, 0}};
    for (int i = 0; i < 300; ++i) add(0, kArcLength * ((i + 0.5) / 300.0 - 0.5), 0.0, 0.45);
  }

  /// A point t along the arc from its middle, d outside of the shell, h above the foot.
  void add(int setup, double t, double d, double h) {
    const double azimuth = 0.5 * kTwoPi / 144.0 + t / kRadius;
    ring_.points.push_back({(kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), h});
    ring_.point_setups.push_back(static_cast<std::uint16_t>(setup));
  }

  /// Twenty points of a setup, half a metre along the arc.
  void addRow(int setup, double d, double h) {
    for (int i = 0; i < 20; ++i) add(setup, 0.025 * (i - 9.5), d, h);
  }

  std::vector<ArcView> views(const ViewScope& scope = {}) const {
    const Tank tank = madeTank();
    const std::vector<Eigen::Vector3d> origins(2, Eigen::Vector3d::Zero());
    return viewArcs(SetupRing(ring_, tank, 1), tank, kReach, origins, scope, 1);
  }

 private:
  Ring ring_;
};

/// Whether two setups that see the same place are compared there.
bool isCompared(double d, double h, double other_d, double other_h) {
  Overlap overlap;
  overlap.addRow(0, d, h);
  overlap.addRow(1, other_d, other_h);
  return !overlap.views().empty();
}

bool isCompared(double d, double h) { return isCompared(d, h, d, h); }

TEST(ViewArcs, TheFoundationIsComparedClearOfTheWeldAndNotBeyondSevenTenthsOfTheReach) {
  EXPECT_FALSE(isCompared(0.019, 0.0));
  EXPECT_TRUE(isCompared(0.021, 0.0));
  EXPECT_TRUE(isCompared(0.345, 0.0));
  EXPECT_FALSE(isCompared(0.355, 0.0));
}

TEST(ViewArcs, TheFoundationLiesWithinTwoFifthsOfTheReachOfTheCoarseFoot) {
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(isCompared(0.1, side * 0.19));
    EXPECT_FALSE(isCompared(0.1, side * 0.21));
  }
}

TEST(ViewArcs, TheShellIsComparedAboveTheWeldAndWhereItStands) {
  EXPECT_FALSE(isCompared(0.0, 0.07));
  EXPECT_TRUE(isCompared(0.0, 0.08));
  EXPECT_TRUE(isCompared(0.0, 0.22, 0.037, 0.22));
  EXPECT_FALSE(isCompared(0.0, 0.22, 0.043, 0.22));
}

/// What setup 1 lies above setup 0, or outside of it, that lie so far apart; NaN where they are not compared.
double offsetSeen(double d, double h, double other_d, double other_h, const ViewScope& scope) {
  Overlap overlap;
  overlap.addRow(0, d, h);
  overlap.addRow(1, other_d, other_h);
  const std::vector<ArcView> views = overlap.views(scope);
  return views.empty() ? kUnknown : views[0].seen.offsets[1] - views[0].seen.offsets[0];
}

TEST(ViewArcs, ASetupThatIsThoughtToBeFarOffIsComparedThere) {
  ViewScope scope;
  EXPECT_TRUE(std::isnan(offsetSeen(0.1, 0.0, 0.1, 0.12, scope)));
  scope.shifts.resize(2);
  scope.shifts[1].dz = 0.118;
  EXPECT_NEAR(offsetSeen(0.1, 0.0, 0.1, 0.12, scope), 0.12, 1e-6) << "as the points were given";
  const double azimuth = 0.5 * kTwoPi / 144.0;
  scope.shifts[1] = {0.0, 0.0, 0.0, 0.117 * std::cos(azimuth), 0.117 * std::sin(azimuth)};
  EXPECT_NEAR(offsetSeen(0.0, 0.22, 0.12, 0.22, scope), 0.12, 1e-4);
  scope = {};
  scope.window *= 5.0;
  EXPECT_NEAR(offsetSeen(0.1, 0.0, 0.1, 0.12, scope), 0.12, 1e-6) << "looked for farther off";
}

TEST(ViewArcs, SetupsMeetInBinsOfTwentyMillimetresAlongTheFoundationAndFiftyUpTheShell) {
  EXPECT_TRUE(isCompared(0.1205, 0.0, 0.1395, 0.0));
  EXPECT_FALSE(isCompared(0.0995, 0.0, 0.1005, 0.0));
  EXPECT_TRUE(isCompared(0.0, 0.201, 0.0, 0.249));
  EXPECT_FALSE(isCompared(0.0, 0.249, 0.0, 0.251));
}

/// What two setups' offsets are known to that see different places of an arc, without noise: the surface's run between
/// them [m]. Setup 0 sees the places `first`, setup 1 `second`, along the arc [m].
double unknownBetween(const std::vector<double>& first, const std::vector<double>& second, double d, double h) {
  Overlap overlap;
  for (int i = 0; i < 400; ++i) {
    overlap.add(0, first[static_cast<std::size_t>(i) % first.size()], d, h);
    overlap.add(1, second[static_cast<std::size_t>(i) % second.size()], d, h);
  }
  const std::vector<ArcView> views = overlap.views();
  EXPECT_EQ(views.size(), 1U);
  return views.empty() ? 0.0 : 1.0 / std::sqrt(views[0].seen.information(0, 0));
}

TEST(ViewArcs, ADatumMayClimbOneInAHundredAShellsOutlineTwoInAHundred) {
  EXPECT_NEAR(unknownBetween({-0.4}, {0.4}, 0.1, 0.0), 0.01 * 0.8, 0.0002);
  EXPECT_NEAR(unknownBetween({-0.4}, {0.4}, 0.0, 0.22), 0.02 * 0.8, 0.0004);
}

TEST(ViewArcs, ADatumBendsAsItsHighestWaveDoes) {
  // 3 mm of amplitude on eight waves round a tank of 30 m: 0.01 / m times half the square of the radius over 1000
  EXPECT_NEAR(unknownBetween({-0.5, 0.5}, {0.0}, 0.1, 0.0), 0.25 * 0.03 / kRadius, 1e-5);
}

TEST(ViewArcs, OfAnArcWithMoreThanSixtyThousandPointsEverySecondIsTaken) {
  const auto information = [](int count) {
    Overlap overlap;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> along(-0.5, 0.5);
    for (int i = 0; i < count; ++i) {
      const double t = along(random);
      overlap.add(static_cast<int>(random() % 2), t, 0.1, 0.001 * normal(random));
    }
    return overlap.views().at(0).seen.information(0, 0);
  };
  EXPECT_NEAR(information(70'000) / information(50'000), 0.7, 0.05);
}

/// A ring of two setups, of which setup 0 alone sees the shell high up, all round.
class WholeOverlap : public Overlap {
 public:
  WholeOverlap() {
    for (int i = 0; i < 1440 * 6; ++i) add(0, kTwoPi * kRadius * (i + 0.5) / (1440 * 6), 0.0, 0.45);
  }

  /// Twelve points of a setup on the foundation in one of the narrowest arcs, so few that eight of these are compared.
  void addFew(int setup, int arc) {
    for (int i = 0; i < 12; ++i) add(setup, kArcLength * (arc + (i - 5.5) / 12.0), 0.11, i % 2 == 0 ? 0.001 : 0.0);
  }
};

TEST(ViewArcs, AWideArcTurnsAboutThePartsInWhichSetupsMeet) {
  WholeOverlap overlap;
  for (const int part : {0, 1, 6, 7}) overlap.addFew(0, part);
  for (const int part : {6, 7}) overlap.addFew(1, part);
  const std::vector<ArcView> views = overlap.views();
  ASSERT_EQ(views.size(), 1U);
  EXPECT_NEAR(std::atan2(views[0].motion(0, 2), views[0].motion(0, 1)), toRadians(17.5), 1e-9);
}

TEST(ViewArcs, SetupsThatSeeDifferentPartsOfAWideArcAreNotCompared) {
  WholeOverlap apart, together;
  apart.addFew(0, 0), apart.addFew(1, 7);
  together.addFew(0, 7), together.addFew(1, 7);
  EXPECT_TRUE(apart.views().empty());
  EXPECT_EQ(together.views().size(), 1U);
}

/// In how many arcs the foundation is compared of which two setups have so many points every 2.5 degrees.
std::size_t comparedArcs(int points) {
  WholeOverlap overlap;
  for (int i = 0; i < 144 * points; ++i) {
    for (const int setup : {0, 1}) overlap.add(setup, kArcLength * ((i + 0.5) / points - 0.5), 0.11, 0.0);
  }
  const std::vector<ArcView> views = overlap.views();
  return static_cast<std::size_t>(
      std::count_if(views.begin(), views.end(), [](const ArcView& view) { return !view.shell; }));
}

TEST(ViewArcs, AreAsWideAsSetupsNeedForAHundredPoints) {
  EXPECT_EQ(comparedArcs(100), 144U);
  EXPECT_EQ(comparedArcs(98), 72U);
  EXPECT_EQ(comparedArcs(50), 72U);
  EXPECT_EQ(comparedArcs(48), 36U);
  EXPECT_EQ(comparedArcs(25), 36U);
  EXPECT_EQ(comparedArcs(5), 18U);
  EXPECT_EQ(comparedArcs(4), 18U);
}

/// Whether two setups are compared on a surface that falls so steeply from the shell.
bool isComparedOnFall(double fall) {
  Overlap overlap;
  for (const double d : {0.05, 0.15, 0.25}) {
    for (const int setup : {0, 1}) overlap.addRow(setup, d, -fall * d);
  }
  return !overlap.views().empty();
}

TEST(ViewArcs, BanksLookAnotherFromEachPlace) {
  EXPECT_TRUE(isComparedOnFall(0.14));
  EXPECT_FALSE(isComparedOnFall(0.16));
}

TEST(ViewArcs, StepsDownAtAPlatesAndARingwallsEdgeAreNoBank) {
  for (const double edge : {0.12, 0.16, 0.2, 0.24, 0.28}) {
    Overlap overlap;
    for (int row = 0; row < 15; ++row) {
      const double d = 0.03 + 0.02 * row;
      for (const int setup : {0, 1}) overlap.addRow(setup, d, d < 0.08 ? 0.0 : d < edge ? -0.03 : -0.19);
    }
    EXPECT_FALSE(overlap.views().empty()) << edge;
  }
}

}  // namespace tank_datum::setup_views_test
