#include "shell/sharp_steps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/made_shells.h"

namespace tank_datum::sharp_steps_test {

using namespace made_shells;

constexpr double kPlace = 2.0;  // azimuth of what is made [rad]

/// A row, 0.2 m high, of a shell that is off its circle by so much at an arc from there [m] and a height above the
/// foot.
struct Row {
  std::function<double(double, double)> off = [](double, double) { return 0.0; };
  std::function<bool(double)> seen = [](double) { return true; };
  double noise = 0.001;
  double points = 1000;  ///< of a metre

  PolarRing ring() const {
    MadeShell shell;
    shell.noise = noise, shell.from = 0.2, shell.to = 0.4;
    shell.count = static_cast<int>(points * kTurn * kRadius);
    shell.radius = [this](double a, double h) { return kRadius + off(kRadius * (a - kPlace), h); };
    shell.seen = [this](double a, double) { return seen(kRadius * (a - kPlace)); };
    return {shell.points(), kCentre};
  }

  std::vector<SharpStep> steps() const { return sharpSteps(ring(), kRadius, noise); }
  bool stepsUpwardsAt(double t = 0.0) const {
    return stepsUpwards(ring(), {kPlace + t / kRadius, 0.1 / kRadius, kFoot + 0.3, 0.1}, noise);
  }
};

/// Of a step between two levels.
Row stepOf(double height, double noise = 0.001, double points = 1000) {
  Row row;
  row.off = [height](double t, double) { return t > 0.0 && t < 4.0 ? height : 0.0; };
  row.noise = noise, row.points = points;
  return row;
}

/// A plate, so thick and wide.
Row plateOf(double thick, double wide) {
  Row row;
  row.off = [=](double t, double) { return std::abs(t) < 0.5 * wide ? thick : 0.0; };
  return row;
}

TEST(SharpSteps, AreFoundWhereTheyAreAndAsHighAsTheyAre) {
  const auto steps = stepOf(0.012).steps();
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_NEAR(kRadius * (steps.at(0).azimuth - kPlace), 0.0, 0.01);
  EXPECT_NEAR(kRadius * (steps.at(1).azimuth - kPlace), 4.0, 0.01);
  EXPECT_NEAR(steps.at(0).height, 0.012, 0.001);
  EXPECT_NEAR(steps.at(1).height, -0.012, 0.001);
}

TEST(SharpSteps, OneMayLieWhereTheRingBegins) {
  Row row;
  row.off = [](double t, double) { return std::cos(0.5 * (t / kRadius + kPlace)) > 0.0 ? 0.012 : 0.0; };
  const auto steps = row.steps();
  ASSERT_EQ(steps.size(), 2U);
  double nearest = 1.0;
  for (const SharpStep& step : steps) nearest = std::min(nearest, std::abs(std::remainder(step.azimuth, kTurn)));
  EXPECT_LT(nearest * kRadius, 0.01);
}

TEST(SharpSteps, AreHigherThanSetupsDisagree) {
  EXPECT_TRUE(stepOf(0.0045, 0.0005).steps().empty());
  EXPECT_EQ(stepOf(0.0075, 0.0005).steps().size(), 2U);
}

TEST(SharpSteps, StandOutOfTheNoise) {  // five standard errors are 8.5 mm
  EXPECT_TRUE(stepOf(0.0065, 0.005).steps().empty());
  EXPECT_EQ(stepOf(0.015, 0.005).steps().size(), 2U);
}

TEST(SharpSteps, ATurnIsNoneHoweverSteep) {
  Row row;
  row.noise = 0.0005;
  for (const double slope : {0.1, 0.2, 0.4}) {
    for (const double high : {0.02, 0.06}) {
      row.off = [=](double t, double) { return std::max(0.0, high - slope * std::abs(t)); };
      EXPECT_TRUE(row.steps().empty()) << "peak of " << slope;
      row.off = [=](double t, double) {
        return std::clamp(slope * t, 0.0, high) - std::clamp(slope * (t - 3.0), 0.0, high);
      };
      EXPECT_TRUE(high / slope < 0.06 || row.steps().empty()) << "ramp of " << slope;
    }
  }
  for (const double deep : {0.02, 0.05, 0.1}) {
    const double wide = kTurn / 2.0 * deep / 0.4;
    row.off = [=](double t, double) {
      return std::abs(t) < 0.5 * wide ? -deep * (0.5 + 0.5 * std::cos(kTurn * t / wide)) : 0.0;
    };
    EXPECT_TRUE(row.steps().empty()) << "dent of " << deep;
  }
}

TEST(SharpSteps, ColumnsAreAsNarrowAsTheirPointsAllow) {
  EXPECT_EQ(plateOf(0.012, 0.14).steps().size(), 2U) << "not seen with columns of 50 mm";
  EXPECT_EQ(stepOf(0.016, 0.005, 700).steps().size(), 2U) << "nor out of the noise with columns of 12 mm";
  EXPECT_EQ(stepOf(0.02, 0.001, 150).steps().size(), 2U) << "columns of 0.1 m";
  EXPECT_TRUE(stepOf(0.02, 0.001, 45).steps().empty()) << "which would have to be of 0.2 m";
}

TEST(SharpSteps, AColumnNeedsFivePoints) {
  Row row = stepOf(0.012, 0.0005);
  const auto thinned = [&](double kept) {  // for 0.6 m on either side, of 1000 points a metre
    row.seen = [kept](double t) { return std::abs(t) > 0.6 || std::fmod(std::abs(t) * 1e6, 1.0) < kept; };
    const auto steps = row.steps();
    return std::any_of(steps.begin(), steps.end(), [](const auto& s) { return s.height > 0.0; });
  };
  EXPECT_TRUE(thinned(0.5));
  EXPECT_TRUE(thinned(0.12)) << "columns of 0.1 m";
  EXPECT_FALSE(thinned(0.06));
}

TEST(SharpSteps, AColumnOfTwoLevelsIsNotSeen) {
  Row row;
  row.off = [](double, double h) { return h > 0.3 ? 0.01 : 0.0; };
  row.noise = 0.0015;
  EXPECT_TRUE(row.steps().empty());
}

TEST(StepsUpwards, AtTheEdgeOfAPlate) {
  Row row;
  for (const double edge : {0.25, 0.3, 0.35}) {
    row.off = [edge](double, double h) { return h > edge ? 0.012 : 0.0; };
    EXPECT_TRUE(row.stepsUpwardsAt()) << edge;
  }
  row.off = [](double, double h) { return h > 0.395 ? 0.012 : 0.0; };
  EXPECT_FALSE(row.stepsUpwardsAt());
}

TEST(StepsUpwards, NotWhereTheShellTurns) {
  Row row;
  row.off = [](double, double h) { return 0.2 * std::abs(h - 0.3); };
  EXPECT_FALSE(row.stepsUpwardsAt());
  row.off = [](double, double h) { return 0.1 * h; };
  EXPECT_FALSE(row.stepsUpwardsAt());
  row.off = [](double, double h) { return h > 0.377 ? 0.012 : 0.0; };
  EXPECT_FALSE(row.stepsUpwardsAt()) << "a layer alone tells no step";
}

}  // namespace tank_datum::sharp_steps_test
