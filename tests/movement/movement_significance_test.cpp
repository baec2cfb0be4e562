// What counts as moved: false alarms of an unmoved tank, and movements that are found.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "support/made_epochs.h"

namespace tank_datum::movement_significance_test {

using made_epochs::Survey;
using made_epochs::with;

TEST(CompareEpochs, AnUnmovedTankRaisesAFalseAlarmInAtMostFivePerCent) {
  int alarms = 0;
  for (unsigned run = 1; run <= 80; ++run) {
    alarms +=
        compareEpochs(with(&Survey::lift, 0, run).epoch(), with(&Survey::lift, 0, 1000 + run).epoch(), {}).significant >
        0;
  }
  EXPECT_LE(alarms, 9);  // binomial(80, 0.05) exceeds it once in 150
  // a threshold far too high would not find the dips of the tests below
}

TEST(CompareEpochs, FindsADipOfTwoMillimetresWhereItIs) {
  int found = 0;
  for (unsigned run = 1; run <= 20; ++run) {
    Survey before = with(&Survey::sigma, 0.0002, run), after = with(&Survey::sigma, 0.0002, 100 + run);
    after.dip = 0.002;
    const Movement m = compareEpochs(before.epoch(), after.epoch(), {});
    bool inside = false;
    for (std::size_t i = 95; i <= 105; ++i) inside = inside || m.stations[i].significant;
    found += inside ? 1 : 0;
    EXPECT_FALSE(m.stations[200].significant && m.stations[300].significant) << run;
  }
  EXPECT_GE(found, 19);
}

TEST(CompareEpochs, StationsOfWideWindowsAreNotTakenForIndependent) {
  int alarms = 0, alarms_of_silent = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    const Survey before = with(&Survey::window, 13 * kDegree, run),
                 after = with(&Survey::window, 13 * kDegree, 500 + run);
    alarms += compareEpochs(before.epoch(), after.epoch(), {}).significant > 0;
    Epoch silent = after.epoch(), silent_before = before.epoch();
    for (Epoch* epoch : {&silent, &silent_before}) {
      for (Elevation& e : epoch->stations) e.window = NAN;
    }
    alarms_of_silent += compareEpochs(silent_before, silent, {}).significant > 0;
  }
  EXPECT_LE(alarms, 6);            // binomial(40, 0.05) exceeds it once in 300
  EXPECT_LE(alarms_of_silent, 6);  // the differences show by themselves over what arc they are shared
}

/// A levelling of a still tank at 24 places, of errors twice the sigma it claims.
Epoch claimedHalf(unsigned seed) {
  Epoch epoch{"levelling", "ok", "refined", "", {{0.0, 0.0}, 30.0}, {}};
  epoch.levelled = true;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, 0.002);
  for (double a = 0.0; a < kTwoPi - 0.01; a += kTwoPi / 24)
    epoch.stations.push_back({a, a, normal(generator), 0.001, NAN});
  return epoch;
}

TEST(CompareEpochs, OfFewStationsSigmasClaimedHalfRaiseNoAlarms) {
  int alarms = 0, means = 0, tilts = 0, moved = 0;
  for (unsigned run = 1; run <= 150; ++run) {
    const Movement m = compareEpochs(claimedHalf(run), claimedHalf(1000 + run), {});
    alarms += m.significant > 0, means += m.mean_significant, tilts += m.tilt_significant, moved += m.moved();
  }
  for (const int count : {alarms, means, tilts}) EXPECT_LE(count, 6);  // binomial(150, 0.0125) exceeds it once in 300
  EXPECT_LE(moved, 14) << "by any of four tests";                      // binomial(150, 0.05) exceeds it once in 80
}

/// A levelling of a millimetre of a tank that is oval by so much.
Epoch levelled(int count, double oval, unsigned seed) {
  Epoch epoch{"levelling", "ok", "refined", "", {{0.0, 0.0}, 30.0}, {}};
  epoch.levelled = true;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, 0.001);
  for (int i = 0; i < count; ++i) {
    const double a = kTwoPi * i / count;
    epoch.stations.push_back({a, a, oval * std::cos(2.0 * a + 0.5) + normal(generator), 0.001, NAN});
  }
  return epoch;
}

TEST(CompareEpochs, ATankThatBecameOvalHasMovedByFewPointsToo) {
  for (const int count : {8, 9, 16, 31}) {
    const double oval = count < 11 ? 0.025 : 0.010;
    int found = 0, alarms = 0;
    for (unsigned run = 1; run <= 60; ++run) {
      const Movement moved = compareEpochs(levelled(count, 0.0, run), levelled(count, oval, 1000 + run), {});
      found += moved.moved() && moved.rest_significant && moved.significant > 0;
      const Movement still = compareEpochs(levelled(count, oval, run), levelled(count, oval, 1000 + run), {});
      alarms += still.significant > 0;
    }
    EXPECT_GE(found, 58) << count;
    EXPECT_LE(alarms, 7) << count;  // binomial(60, 0.05) exceeds it once in 70
  }
}

/// A scan of a still tank whose setups leave height, tilt and a second wave of a millimetre that its stations share.
Epoch ofSetups(unsigned seed, bool told) {
  Epoch epoch{"scan", "ok", "refined", "foundation", {{0.0, 0.0}, 30.0}, {}};
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> errors(5);
  for (double& error : errors) error = normal(generator);
  for (int i = 0; i < 360; ++i) {
    const double a = i * kDegree;
    std::vector<double> shared = {0.001, 0.001 * std::cos(a), 0.001 * std::sin(a), 0.001 * std::cos(2.0 * a),
                                  0.001 * std::sin(2.0 * a)};
    double z = 0.0002 * normal(generator), squares = 0.0002 * 0.0002;
    for (std::size_t k = 0; k < errors.size(); ++k) z += shared[k] * errors[k], squares += shared[k] * shared[k];
    if (!told) shared.clear();
    epoch.stations.push_back({a, a, z, std::sqrt(squares), 2.0 * kDegree, shared});
  }
  return epoch;
}

TEST(CompareEpochs, ErrorsOfSetupsAreNoMovement) {
  int alarms = 0, means = 0, tilts = 0, untold = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    const Movement m = compareEpochs(ofSetups(run, true), ofSetups(1000 + run, true), {});
    alarms += m.significant > 0, means += m.mean_significant, tilts += m.tilt_significant;
    untold += compareEpochs(ofSetups(run, false), ofSetups(1000 + run, false), {}).mean_significant;
  }
  for (const int count : {alarms, means, tilts}) EXPECT_LE(count, 6);  // binomial(40, 0.05) exceeds it once in 300
  EXPECT_GE(untold, 20) << "a mean over stations that share errors is not that of as many";
}

TEST(CompareEpochs, SigmasClaimedHalfRaiseNoAlarms) {
  int alarms = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    Epoch before = with(&Survey::lift, 0, run).epoch(), after = with(&Survey::lift, 0, 700 + run).epoch();
    for (Epoch* epoch : {&before, &after}) {
      for (Elevation& e : epoch->stations) e.sigma_z *= 0.5;
    }
    const Movement m = compareEpochs(before, after, {});
    EXPECT_NEAR(m.errors_shown, 2.0, 0.5);
    alarms += m.significant > 0;
  }
  EXPECT_LE(alarms, 6);  // binomial(40, 0.05) exceeds it once in 300
}

TEST(CompareEpochs, ASectorThatMovedLeavesTheOthersUnmoved) {
  Survey before = with(&Survey::sigma, 0.0002, 3), after = with(&Survey::sigma, 0.0002, 4);
  Epoch later = after.epoch();
  for (std::size_t i = 200; i < 260; ++i) later.stations[i].z -= 0.005;
  for (const Removal removal : {Removal::Mean, Removal::Tilt}) {
    MovementOptions options;
    options.removal = removal;
    const Movement m = compareEpochs(before.epoch(), later, options);
    for (std::size_t i = 0; i < 360; ++i) {
      if (i >= 205 && i < 255) {
        EXPECT_TRUE(m.stations[i].significant) << i;
      } else if (i < 190 || i >= 270) {
        EXPECT_FALSE(m.stations[i].significant) << i;
      }
    }
  }
}

TEST(CompareEpochs, SettlementAndTiltOfTheWholeHaveTestsOfTheirOwn) {
  Survey before, after;
  before.count = after.count = 24;
  before.sigma = after.sigma = 0.001, before.window = after.window = 2 * kDegree;
  after.lift = -0.002;
  const Movement dropped = compareEpochs(before.epoch(), after.epoch(), {});
  EXPECT_NEAR(dropped.mean, -0.002, 1e-12);
  EXPECT_NEAR(dropped.sigma_mean, std::hypot(0.001 * std::sqrt(2.0 / 24.0), made_epochs::kShared), 1e-6);
  EXPECT_TRUE(dropped.mean_significant);
  EXPECT_GT(dropped.tilt_p_value, 0.99);
  MovementOptions loose;
  loose.registration_error = 0.002;
  EXPECT_FALSE(compareEpochs(before.epoch(), after.epoch(), loose).mean_significant);
  after.lift = 0.0, after.tilt = 0.003;
  const Movement tilted = compareEpochs(before.epoch(), after.epoch(), {});
  EXPECT_NEAR(tilted.tilt_change, 0.003 / 30.0, 1e-9);
  EXPECT_NEAR(tilted.sigma_tilt_change, 0.001 * std::sqrt(2.0 * 2.0 / 24.0) / 30.0, 1e-9);
  EXPECT_LT(tilted.tilt_p_value, 1e-6);
  EXPECT_FALSE(tilted.mean_significant);
}

TEST(CompareEpochs, ALargeDipDoesNotSpreadOverTheWidestWindow) {
  const Movement m = compareEpochs(Survey().epoch(), with(&Survey::dip, 0.012).epoch(), {});
  for (std::size_t i = 97; i <= 103; ++i) EXPECT_TRUE(m.stations[i].significant) << i;
  for (std::size_t i = 0; i < 360; ++i) {
    if (i < 85 || i > 115) {
      EXPECT_FALSE(m.stations[i].significant) << i;
    }
  }
}

TEST(CompareEpochs, ADipIsSignificantElsewhereNoMoreOftenThanAnUnmovedTank) {
  int elsewhere = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    Survey after = with(&Survey::dip, 0.002, 100 + run);
    const Movement m = compareEpochs(with(&Survey::dip, 0.0, run).epoch(), after.epoch(), {});
    bool far = false;
    for (std::size_t i = 0; i < 360; ++i) far = far || (m.stations[i].significant && (i < 90 || i > 110));
    elsewhere += far ? 1 : 0;
  }
  EXPECT_LE(elsewhere, 6);  // binomial(40, 0.05) exceeds it once in 300
}

TEST(CompareEpochs, AWideMovementBesideADipIsFoundToo) {
  Survey before = with(&Survey::sigma, 0.0002, 1), after = with(&Survey::sigma, 0.0002, 2);
  after.dip = 0.004;
  Epoch later = after.epoch();
  for (std::size_t i = 200; i < 260; ++i) later.stations[i].z -= 0.0016;
  const Movement m = compareEpochs(before.epoch(), later, {});
  std::size_t wide = 0, none = 0;
  for (std::size_t i = 0; i < 360; ++i) {
    if (i >= 210 && i < 250) wide += m.stations[i].significant ? 1 : 0;
    if (i >= 130 && i < 170) none += m.stations[i].significant ? 1 : 0;
  }
  EXPECT_GT(wide, 20U);
  EXPECT_EQ(none, 0U);
  EXPECT_TRUE(m.stations[100].significant);
}

TEST(CompareEpochs, ASingleStationOffIsNoMovement) {
  Survey wide;
  wide.count = 36;
  Epoch later = Survey().epoch(), coarse = wide.epoch();
  later.stations[50].z += 0.003;
  const Movement m = compareEpochs(Survey().epoch(), later, {});
  EXPECT_EQ(m.significant, 0U);
  EXPECT_NEAR(m.max, 0.003, 1e-12);
  later.stations[51].z += 0.003, later.stations[52].z += 0.003, later.stations[53].z += 0.003;
  EXPECT_GT(compareEpochs(Survey().epoch(), later, {}).significant, 2U);
  const Epoch before = coarse;
  coarse.stations[5].z += 0.003;  // 10 degrees from its neighbours it is all there is
  EXPECT_EQ(compareEpochs(before, coarse, {}).significant, 1U);
}
}  // namespace tank_datum::movement_significance_test
