
#include "tank_datum/movement/movement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

/// A survey of a 30 m tank: its shape, errors of `sigma` that stations share within `window`, and a dip.
struct Survey {
  std::size_t count = 360;
  unsigned seed = 0;  ///< 0: no errors
  double sigma = 0.0003, window = 2 * kDegree, dip = 0.0, width = 10 * kDegree, lift = 0.0, tilt = 0.0, turned = 0.0;

  Epoch epoch() const {
    Epoch epoch{"survey", "ok", "refined", "foundation", {{10.0, -5.0}, 30.0}, {}};
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    const double step = 360.0 / static_cast<double>(count);
    const auto shared = static_cast<std::size_t>(std::max(1.0, std::round(window / kDegree / step)));
    std::vector<double> white(count);
    for (double& w : white) w = normal(generator) / std::sqrt(static_cast<double>(shared));
    for (std::size_t i = 0; i < count; ++i) {
      const double a = static_cast<double>(i) * step * kDegree, b = a + turned;
      double error = 0.0;
      for (std::size_t k = 0; k < shared; ++k) error += white[(i + k) % count];
      const double off = std::remainder(b - 100 * kDegree, 360 * kDegree) / (0.5 * width);
      double z = 1.0 + 0.006 * std::cos(2 * b) + 0.004 * std::sin(3 * b) + lift + tilt * std::cos(b);
      if (std::abs(off) < 1.0) z -= dip * 0.5 * (1.0 + std::cos(3.14159265358979 * off));
      epoch.stations.push_back({a, a, z + (seed > 0 ? sigma * error : 0.0), sigma, window});
    }
    return epoch;
  }
};

Survey with(double Survey::*field, double value, unsigned seed = 0) {
  Survey survey;
  survey.seed = seed;
  survey.*field = value;
  return survey;
}

std::string refusal(const Epoch& a, const Epoch& b, const MovementOptions& options = {}) {
  try {
    compareEpochs(a, b, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Option);
    return error.what();
  }
  return "";
}

TEST(CompareEpochs, AnUnmovedTankRaisesAFalseAlarmInAtMostFivePerCent) {
  int alarms = 0;
  for (unsigned run = 1; run <= 80; ++run) {
    alarms +=
        compareEpochs(with(&Survey::lift, 0, run).epoch(), with(&Survey::lift, 0, 1000 + run).epoch(), {}).significant >
        0;
  }
  EXPECT_LE(alarms, 9);  // binomial(80, 0.05) exceeds it once in 150
  EXPECT_GE(alarms, 1);  // and has none once in 60: a threshold far too high
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
  EXPECT_NEAR(dropped.mean / dropped.sigma_mean, -0.002 / (0.001 * std::sqrt(2.0 / 24.0)), 0.01);  // 7 sigma
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
  for (std::size_t i = 200; i < 260; ++i) later.stations[i].z -= 0.0004;
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

TEST(CompareEpochs, KnowsAnExactMovementAndItsLevelOfDetection) {
  const Movement m = compareEpochs(Survey().epoch(), with(&Survey::dip, 0.002).epoch(), {});
  EXPECT_NEAR(m.stations[100].dz, -0.002, 1e-12);
  EXPECT_NEAR(m.stations[200].dz, 0.0, 1e-12);
  EXPECT_NEAR(m.stations[0].lod95(), 1.96 * 0.0003 * std::sqrt(2.0), 1e-7);
  EXPECT_EQ(m.matched, 360U);
  EXPECT_NEAR(m.max, -0.002, 1e-12);
  EXPECT_NEAR(m.max_azimuth, 100 * kDegree, 1e-9);
}

TEST(CompareEpochs, RemovesWhatIsAskedFor) {
  Survey later = with(&Survey::lift, 0.01);
  later.tilt = 0.004;
  const auto rms = [&](Removal removal) {
    MovementOptions options;
    options.removal = removal;
    return compareEpochs(Survey().epoch(), later.epoch(), options).rms;
  };
  EXPECT_NEAR(rms(Removal::Nothing), std::sqrt(1e-4 + 8e-6), 1e-9);
  EXPECT_NEAR(rms(Removal::Mean), std::sqrt(8e-6), 1e-9);
  EXPECT_NEAR(rms(Removal::Tilt), 0.0, 1e-9);
}

TEST(CompareEpochs, ARegistrationErrorWidensTheLevelOfDetection) {
  MovementOptions options;
  options.registration_error = 0.004;
  const Movement m = compareEpochs(Survey().epoch(), with(&Survey::lift, 0.002).epoch(), options);
  EXPECT_NEAR(m.stations[0].sigma, std::hypot(0.004, 0.0003 * std::sqrt(2.0)), 1e-12);
  EXPECT_EQ(m.significant, 0U);
  EXPECT_EQ(compareEpochs(Survey().epoch(), with(&Survey::lift, 0.002).epoch(), {}).significant, 360U);
}

TEST(CompareEpochs, ARegistrationTiltWidensItByTheHeightAtTheShell) {
  Survey later = with(&Survey::tilt, 0.002);
  MovementOptions options;
  options.registration_tilt = 0.0001;  // 3 mm at 30 m
  const Movement m = compareEpochs(Survey().epoch(), later.epoch(), options);
  EXPECT_NEAR(m.stations[0].sigma, std::hypot(0.003, 0.0003 * std::sqrt(2.0)), 1e-12);
  EXPECT_EQ(m.significant, 0U);
  EXPECT_GT(compareEpochs(Survey().epoch(), later.epoch(), {}).significant, 200U);
}

TEST(CompareEpochs, NeighboursThatShareErrorsProveLess) {
  MovementOptions apart, together;
  apart.correlation = 0.5 * kDegree;
  together.correlation = 20 * kDegree;
  const auto found = [](const MovementOptions& o) {
    return compareEpochs(Survey().epoch(), with(&Survey::lift, 0.0006).epoch(), o).significant;
  };
  EXPECT_EQ(found(apart), 360U);
  EXPECT_EQ(found(together), 0U);
}

TEST(CompareEpochs, EstimatesTheTurnFromTheShapeWithItsUncertainty) {
  MovementOptions options;
  options.estimate_offset = true;
  const Movement m =
      compareEpochs(with(&Survey::lift, 0, 1).epoch(), with(&Survey::turned, 37.25 * kDegree, 2).epoch(), options);
  EXPECT_GT(m.sigma_azimuth_offset, 0.01 * kDegree);
  EXPECT_LT(m.sigma_azimuth_offset, 2 * kDegree);
  EXPECT_NEAR(m.azimuth_offset, 37.25 * kDegree, 3 * m.sigma_azimuth_offset);
  MovementOptions given;
  given.azimuth_offset = 37.25 * kDegree;
  EXPECT_NEAR(compareEpochs(Survey().epoch(), with(&Survey::turned, 37.25 * kDegree).epoch(), given).rms, 0, 1e-5);
  EXPECT_GT(compareEpochs(Survey().epoch(), with(&Survey::turned, 37.25 * kDegree).epoch(), {}).rms, 0.003);
  Epoch level = Survey().epoch();
  for (Elevation& e : level.stations) e.z = 1.0;
  EXPECT_NE(refusal(level, level, options).find("azimuth offset"), std::string::npos);
}

TEST(CompareEpochs, ComparesSurveysOfOtherStationCountsWhereBothWereMeasured) {
  Survey coarse, fine;
  coarse.count = 36, fine.count = 720;
  const Movement m = compareEpochs(Survey().epoch(), fine.epoch(), {});
  EXPECT_EQ(m.matched, 720U);
  EXPECT_LT(m.rms, 2e-6);  // the baseline's interpolation
  EXPECT_EQ(compareEpochs(coarse.epoch(), Survey().epoch(), {}).matched, 36U);
  Epoch gap = Survey().epoch();
  for (std::size_t i = 40; i < 80; ++i) gap.stations[i].z = NAN;
  const Movement partly = compareEpochs(Survey().epoch(), gap, {});
  EXPECT_EQ(partly.matched, 320U);
  EXPECT_TRUE(std::isnan(partly.stations[50].dz));
  EXPECT_FALSE(partly.stations[50].significant);
  for (std::size_t i = 5; i < 360; ++i) gap.stations[i].z = NAN;
  EXPECT_FALSE(compareEpochs(Survey().epoch(), gap, {}).valid());
  gap.status = "no_tank";
  EXPECT_NE(compareEpochs(Survey().epoch(), gap, {}).message.find("no_tank"), std::string::npos);
}

TEST(CompareEpochs, RefusesOtherTanksUnitsMethodsAndSurfaces) {
  const Epoch one = Survey().epoch();
  Epoch other = one;
  other.circle.radius = 30.06;
  EXPECT_NE(refusal(one, other).find("radius"), std::string::npos);
  MovementOptions wide;
  wide.radius_difference = 0.1;
  EXPECT_EQ(refusal(one, other, wide), "");
  other.circle.radius = 30.0 / 0.3048;
  EXPECT_NE(refusal(one, other).find("ft and m"), std::string::npos);
  other = one, other.circle.center.x() += 0.3;
  EXPECT_NE(refusal(one, other).find("centre"), std::string::npos);
  wide.centre_distance = 0.5;
  EXPECT_EQ(refusal(one, other, wide), "");
  other = one, other.method = "paper";
  EXPECT_NE(refusal(one, other).find("no standard errors"), std::string::npos);
  other = one, other.surface = "ringwall";
  EXPECT_NE(refusal(one, other).find("ringwall"), std::string::npos);
}

TEST(MovementOptions, AreRefusedByName) {
  const auto refused = [](double MovementOptions::*field, double value) {
    MovementOptions options;
    options.*field = value;
    return firstError(options);
  };
  EXPECT_EQ(firstError(MovementOptions{}), "");
  EXPECT_NE(refused(&MovementOptions::registration_error, -1).find("registration_error"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::registration_tilt, -1).find("registration_tilt"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::correlation, NAN).find("correlation"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::radius_difference, 0).find("radius_difference"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::centre_distance, 0).find("centre_distance"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::azimuth_offset, INFINITY).find("azimuth_offset"), std::string::npos);
  MovementOptions both;
  both.estimate_offset = true, both.azimuth_offset = 1.0;
  EXPECT_NE(firstError(both).find("azimuth_offset"), std::string::npos);
  EXPECT_NE(refusal(Survey().epoch(), Survey().epoch(), both), "");
}

}  // namespace
}  // namespace tank_datum
