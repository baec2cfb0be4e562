#include "trust/tests_of_tank.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "trust/tank_tests.h"

namespace tank_datum::tests_of_tank_test {

constexpr double kRadius = 5.0;

/// Of a good tank.
ShellEvidence evidence() {
  ShellEvidence shell;
  shell.sectors = 360;
  shell.circle = {{0.0, 0.0}, kRadius};
  shell.spacing = 0.01;
  shell.noise = 0.001;
  shell.off_round = 0.01;
  shell.on_circle = 1.0;
  shell.sigma_radius = 0.001;
  shell.cone = 0.001;
  shell.sigma_cone = 0.001;
  return shell;
}

TestOutcome outcomeOf(const std::vector<TankTest>& tests, const std::string& name) {
  const auto found = std::find_if(tests.begin(), tests.end(), [&](const TankTest& t) { return t.name == name; });
  EXPECT_NE(found, tests.end()) << name;
  if (found == tests.end()) return TestOutcome::Pass;
  EXPECT_FALSE(found->finding.empty()) << name;
  return found->outcome;
}

/// The outcomes of a test at a value just below and just above each of its two bounds.
void expectBounds(const std::string& name, const std::function<std::vector<TankTest>(double)>& tests, double doubtful,
                  double fail) {
  EXPECT_EQ(outcomeOf(tests(0.97 * doubtful), name), TestOutcome::Pass) << name;
  EXPECT_EQ(outcomeOf(tests(1.03 * doubtful), name), TestOutcome::Doubtful) << name;
  EXPECT_EQ(outcomeOf(tests(0.97 * fail), name), TestOutcome::Doubtful) << name;
  EXPECT_EQ(outcomeOf(tests(1.03 * fail), name), TestOutcome::Fail) << name;
}

TEST(TestsOfShell, AGoodTankPasses) {
  const auto tests = testsOfShell(Tank(), evidence());
  EXPECT_EQ(tests.size(), 5U);
  EXPECT_EQ(worstOf(tests), TestOutcome::Pass);
  EXPECT_TRUE(findingsOf(tests).empty());
}

TEST(TestsOfShell, ALowWallIsDoubtfulWhereSomethingLiesBehindATenthOfIt) {
  const auto at = [](double share) {
    Tank tank;
    tank.low_wall = share;
    return outcomeOf(testsOfShell(tank, evidence()), "low_wall");
  };
  EXPECT_EQ(at(0.09), TestOutcome::Pass);
  EXPECT_EQ(at(0.11), TestOutcome::Doubtful);
  EXPECT_EQ(at(1.0), TestOutcome::Doubtful);
}

TEST(TestsOfShell, Bounds) {
  expectBounds(
      "behind",
      [](double share) {
        Tank tank;
        tank.behind_share = share;
        tank.behind = 3.0;
        return testsOfShell(tank, evidence());
      },
      0.10, 0.25);
  const auto with = [](double ShellEvidence::*field, double factor) {
    return [=](double value) {
      ShellEvidence shell = evidence();
      shell.*field = factor * value;
      return testsOfShell(Tank(), shell);
    };
  };
  const double explained = std::hypot(0.004 * kRadius, 0.001);
  expectBounds("round", with(&ShellEvidence::off_round, explained), 1.6, 3.2);
  expectBounds("radius", with(&ShellEvidence::sigma_radius, kRadius), 0.04, 0.08);
  expectBounds(
      "cone",
      [](double value) {
        ShellEvidence shell = evidence();
        shell.cone = -(value + 3.0 * shell.sigma_cone);
        return testsOfShell(Tank(), shell);
      },
      0.05, 0.36);
  expectBounds(
      "off_circle",
      [](double value) {
        ShellEvidence shell = evidence();
        shell.on_circle = 1.0 - value;
        return testsOfShell(Tank(), shell);
      },
      0.25, 0.5);
}

TEST(TestsOfShell, NoiseExplainsUpToTheSpacing) {
  ShellEvidence shell = evidence();
  shell.off_round = 0.045;
  EXPECT_EQ(outcomeOf(testsOfShell(Tank(), shell), "round"), TestOutcome::Doubtful);
  shell.noise = shell.spacing = 0.05;
  EXPECT_EQ(outcomeOf(testsOfShell(Tank(), shell), "round"), TestOutcome::Pass);
  shell.spacing = 0.005;  // then 50 mm are no noise of a wall
  EXPECT_EQ(outcomeOf(testsOfShell(Tank(), shell), "round"), TestOutcome::Doubtful);
}

/// Stations of which so many are measured, with a plane and one wave.
std::vector<Station> stationsOf(int measured, double slope, double wave) {
  StationOptions options;
  std::vector<Station> stations = emptyStations(options);
  for (int i = 0; i < measured; ++i) {
    Station& s = stations[static_cast<std::size_t>(i)];
    s.flag = StationFlag::Measured;
    s.x = kRadius * std::cos(s.direction);
    s.y = kRadius * std::sin(s.direction);
    s.z = slope * s.x + wave * std::cos(3 * s.direction);
    s.sigma_z = 0.0005;
    s.radius = kRadius;
    s.sigma_radius = 0.001;
  }
  return stations;
}

std::vector<TankTest> testsOf(int measured, double slope, double wave) {
  std::vector<Station> stations = stationsOf(measured, slope, wave);
  const Tilt tilt = fitTilt(stations, {0.0, 0.0}, StationOptions());
  stations = withParts(stations, standingsTo(tilt, stations, {0.0, 0.0}));
  return testsOfStations(stations, levelOf(stations), tilt, evidence());
}

TEST(TestsOfStations, Bounds) {
  EXPECT_EQ(worstOf(testsOf(360, 0.01, 0.01)), TestOutcome::Pass);
  EXPECT_EQ(outcomeOf(testsOf(31, 0.0, 0.0), "stations"), TestOutcome::Pass);
  EXPECT_EQ(outcomeOf(testsOf(29, 0.0, 0.0), "stations"), TestOutcome::Doubtful);
  EXPECT_EQ(outcomeOf(testsOf(14, 0.0, 0.0), "stations"), TestOutcome::Fail);
  const double unknown = 6.0 * 0.0005 + 2.0 * 0.01, diameter = 2.0 * kRadius;
  const auto sloping = [&](double share) { return testsOf(360, share + unknown / diameter, 0.0); };
  expectBounds("level", sloping, 0.05, 0.1);
  const auto waving = [&](double share) { return testsOf(360, 0.0, 0.5 * (share * diameter + unknown)); };
  expectBounds("waves", waving, 0.01, 0.02);
}

TEST(TestsOfStations, TheSameOfAnyTurn) {
  EXPECT_EQ(outcomeOf(testsOf(360, 0.03, 0.0), "level"), TestOutcome::Pass);  // 1.7 degrees
  EXPECT_EQ(outcomeOf(testsOf(360, 0.03, 0.0), "waves"), TestOutcome::Pass);
}

TEST(StationsOffCircle, AreOnAnotherThing) {
  std::vector<Station> stations = stationsOf(360, 0.0, 0.0);
  stations[10].radius = kRadius + 0.3;                                   // a pipe beside the shell
  stations[20].radius = kRadius - 0.055;                                 // 3 times 0.4 % of the radius are 60 mm
  stations[30].radius = kRadius + 0.3, stations[30].sigma_radius = 0.2;  // as badly known as that
  const auto off = [&] { return stationsOffCircle(stations, {{0.0, 0.0}, kRadius}, evidence()); };
  EXPECT_EQ(off(), (std::vector<std::size_t>{10}));
  stations[20].radius = kRadius - 0.065;
  EXPECT_EQ(off(), (std::vector<std::size_t>{10, 20}));
  stations[10].flag = StationFlag::Missing;
  EXPECT_EQ(off(), (std::vector<std::size_t>{20}));
}

TEST(FindingsOf, NamesTheWorstAlone) {
  std::vector<TankTest> tests(3);
  tests[0].outcome = TestOutcome::Doubtful, tests[0].finding = "one";
  tests[1].outcome = TestOutcome::Fail, tests[1].finding = "two";
  tests[2].outcome = TestOutcome::Fail, tests[2].finding = "three";
  EXPECT_EQ(worstOf(tests), TestOutcome::Fail);
  EXPECT_EQ(findingsOf(tests), "two; three");
  EXPECT_STREQ(nameOf(TestOutcome::Doubtful), "doubtful");
}

TEST(TestsOfGap, AFifthOfTheReachBeyondThreeSpacingsIsDoubtfulAndNeverMore) {
  const auto at = [](double gap) { return outcomeOf(testsOfGap(0.03 + gap, 0.5, evidence()), "shell_gap"); };
  EXPECT_EQ(at(-0.02), TestOutcome::Pass);
  EXPECT_EQ(at(0.097), TestOutcome::Pass);
  EXPECT_EQ(at(0.103), TestOutcome::Doubtful);
  EXPECT_EQ(at(0.5), TestOutcome::Doubtful);
}

TEST(TestsUnderShell, AFoundationThatGoesOnUnderItsWallIsDoubtfulAndNeverMore) {
  const auto at = [](double share) { return outcomeOf(testsUnderShell(share), "under_shell"); };
  EXPECT_EQ(at(0.0), TestOutcome::Pass);
  EXPECT_EQ(at(0.19), TestOutcome::Pass);
  EXPECT_EQ(at(0.26), TestOutcome::Doubtful);
  EXPECT_EQ(at(1.0), TestOutcome::Doubtful);
  EXPECT_TRUE(testsUnderShell(kUnknown).empty());
}

TEST(TestsOfGround, GroundInsideTheCircleBesideItsWallIsDoubtfulAndNeverMore) {
  const auto at = [](double share) { return outcomeOf(testsOfGround(share), "see_through"); };
  EXPECT_EQ(at(0.24), TestOutcome::Pass);
  EXPECT_EQ(at(0.26), TestOutcome::Doubtful);
  EXPECT_EQ(at(2.0), TestOutcome::Doubtful);
  EXPECT_TRUE(testsOfGround(kUnknown).empty());
}

TEST(TestsAboveShell, AShellThatIsSeenBelowItsFootIsDoubtfulAndNeverMore) {
  const auto at = [](double share) { return outcomeOf(testsAboveShell(share), "above_shell"); };
  EXPECT_EQ(at(0.0), TestOutcome::Pass);
  EXPECT_EQ(at(0.02), TestOutcome::Pass);
  EXPECT_EQ(at(0.04), TestOutcome::Doubtful);
  EXPECT_EQ(at(1.0), TestOutcome::Doubtful);
  EXPECT_TRUE(testsAboveShell(kUnknown).empty());
}

TEST(TestsOfRaised, AFootAboveWhereItsShellIsSeenElsewhereIsDoubtfulAndNeverMore) {
  const auto at = [](double raised) { return outcomeOf(testsOfRaised(raised), "raised"); };
  EXPECT_EQ(at(-20.0), TestOutcome::Pass);
  EXPECT_EQ(at(2.9), TestOutcome::Pass);
  EXPECT_EQ(at(3.1), TestOutcome::Doubtful);
  EXPECT_EQ(at(100.0), TestOutcome::Doubtful);
  EXPECT_TRUE(testsOfRaised(kUnknown).empty());
}

TEST(TestsOfSigma, StationsKnownToMoreThanAPlatesThicknessAreDoubtfulAndNeverNone) {
  std::vector<Station> stations = stationsOf(101, 0.0, 0.0);
  const auto at = [&](double sigma, double unit) {
    for (Station& s : stations) s.sigma_z = sigma;
    return outcomeOf(testsOfSigma(stations, unit), "sigma");
  };
  EXPECT_EQ(at(0.0059, 1.0), TestOutcome::Pass);
  EXPECT_EQ(at(0.0061, 1.0), TestOutcome::Doubtful);
  EXPECT_EQ(at(1.0, 1.0), TestOutcome::Doubtful);
  EXPECT_EQ(at(0.0061, 2.0), TestOutcome::Pass);  // a scan in which all is twice as large
  EXPECT_TRUE(testsOfSigma({}, 1.0).empty());
}

TEST(TestsOfSigma, AsksTheMiddleStationAndNotWhatSetupsDisagreeBy) {
  std::vector<Station> stations = stationsOf(101, 0.0, 0.0);
  for (std::size_t i = 0; i < 49; ++i) stations[i].sigma_z = 0.1;  // fewer than half
  EXPECT_EQ(outcomeOf(testsOfSigma(stations, 1.0), "sigma"), TestOutcome::Pass);
  for (Station& s : stations) s.sigma_z = 0.01, s.sigma_setup = 0.009;  // 4.4 mm of its own
  EXPECT_EQ(outcomeOf(testsOfSigma(stations, 1.0), "sigma"), TestOutcome::Pass);
}

TEST(TestsOfGap, ThereIsNoneWhereTheShellIsNotKnown) {
  EXPECT_TRUE(testsOfGap(kUnknown, 0.5, evidence()).empty());
  EXPECT_TRUE(testsOfGap(0.1, 0.5, ShellEvidence()).empty());
}

}  // namespace tank_datum::tests_of_tank_test
