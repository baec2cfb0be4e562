#include "movement/movement_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_differences.h"

namespace tank_datum::movement_errors_test {

using made_differences::differences;

double meanScale(std::size_t shared, double errors) {
  double sum = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) sum += shownErrors(differences(360, shared, seed, errors)).shown / 20;
  return sum;
}

TEST(ShownErrors, AreThoseOfTheStations) {
  EXPECT_NEAR(meanScale(1, 0.001), 1.0, 0.07);
  EXPECT_NEAR(meanScale(1, 0.002), 2.0, 0.14);
  EXPECT_NEAR(meanScale(5, 0.001), 1.0, 0.10);
}

TEST(ShownErrors, KnowTheArcThatNeighboursShare) {
  for (const std::size_t shared : {5U, 20U}) {
    double arc = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed)
      arc += shownErrors(differences(360, shared, seed)).shared / kDegree / 20;
    EXPECT_GT(arc, 0.85 * static_cast<double>(shared));
    EXPECT_LT(arc, 1.6 * static_cast<double>(shared));
  }
  EXPECT_LT(shownErrors(differences(360, 1, 3)).shared, 4.0 * kDegree);
}

TEST(ShownErrors, AreNotMovedByASectorThatIs) {
  auto stations = differences(360, 1, 5);
  for (std::size_t i = 100; i < 160; ++i) stations[i].dz -= 0.015;
  EXPECT_NEAR(shownErrors(stations).shown, 1.0, 0.45);
}

TEST(ShownErrors, PatchesThreeTimesTheUsualScatterOffHaveMovedAndShareNoError) {
  // a third of the stations, in patches of eight: the usual scatter is then 1.7 mm
  for (unsigned seed = 1; seed <= 8; ++seed) {
    auto stations = differences(360, 1, seed);
    for (std::size_t i = 0; i < 360; ++i) {
      if (i % 24 < 8) stations[i].dz += i / 24 % 2 == 0 ? -0.0065 : 0.0065;
    }
    EXPECT_LT(shownErrors(stations).shared, 3.0 * kDegree) << seed;  // a station or two
  }
}

TEST(ShownErrors, AreNotAWaveOfTheWholeRing) {
  for (const int n : {2, 3, 5}) {
    auto stations = differences(360, 1, 7);
    for (MatchedStation& m : stations) m.dz += 0.010 * std::cos(n * m.direction + 1.0);
    const MovementErrors errors = shownErrors(stations);
    EXPECT_NEAR(errors.shown, 1.0, 0.15) << n;
    EXPECT_LT(errors.shared, 4.0 * kDegree) << n;
  }
}

TEST(ShownErrors, AWaveIsNoErrorWhenItsPowerIsFiftyTimesThatOfShorterOnes) {
  const auto shown = [](double amplitude) {
    auto stations = differences(360, 1, 7, 0.0);
    for (MatchedStation& m : stations) {
      for (int n = 6; n <= 14; ++n) m.dz += 0.0005 * std::cos(n * m.direction + n * n);
      m.dz += 0.0005 * amplitude * std::cos(3.0 * m.direction);
    }
    return shownErrors(stations).shown;
  };
  const double without = shown(0.0);
  EXPECT_GT(shown(6.6), 1.5 * without);             // power 44: may be an error that neighbours share
  EXPECT_NEAR(shown(7.5), without, 0.1 * without);  // power 56
}

/// Values that scatter by `scatter` of their sigma as the biweight midvariance has it, without chance.
std::vector<MatchedStation> scattered(std::size_t count, double scatter) {
  auto stations = differences(count, 1, 1, 0.0);
  const double off = scatter * 76.0 / 80.0 * std::sqrt(1.0 - 3.0 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) stations[i].dz = (i % 2 == 0 ? off : -off) * stations[i].sigma;
  return stations;
}

TEST(ShownErrors, FewStationsMustShowAQuarterMoreThanGiven) {
  EXPECT_NEAR(shownErrors(scattered(14, 1.15)).shown, 1.15, 0.02);
  EXPECT_EQ(shownErrors(scattered(14, 1.15)).scale, 1.0);
  EXPECT_NEAR(shownErrors(scattered(14, 1.35)).scale, 1.35, 0.02);
  EXPECT_NEAR(shownErrors(scattered(18, 1.15)).scale, 1.15, 0.02);
}

TEST(ShownErrors, AWaveOfElevenStationsIsToldFromErrorsOfTenItIsNot) {
  const auto shown = [](std::size_t count) {
    auto stations = differences(count, 1, 7);
    for (MatchedStation& m : stations) m.dz += 0.010 * std::cos(2.0 * m.direction + 1.0);
    return shownErrors(stations).shown;
  };
  for (const std::size_t count : {11U, 12U, 16U, 24U, 31U}) EXPECT_LT(shown(count), 2.0) << count;
  EXPECT_GT(shown(10), 4.0);
}

TEST(ShownErrors, TheyAreAtMostFourTimesAsLargeAsStated) {
  const auto of = [](double scatter) { return shownErrors(scattered(10, scatter)); };
  EXPECT_NEAR(of(3.9).scale, 3.9, 0.05);
  EXPECT_GT(of(3.9).freedom, 0.0);
  EXPECT_EQ(of(4.2).scale, 4.0);
  EXPECT_EQ(of(4.2).freedom, 0.0);
  EXPECT_NEAR(of(40.0).shown, 40.0, 0.5);
}

TEST(ShownErrors, WhatNeighboursDoNotShareIsErrorHoweverLarge) {
  const auto sixfold = [](std::size_t shared) {
    auto stations = differences(360, shared, 3);
    for (MatchedStation& m : stations) m.dz *= 6.0;
    return shownErrors(stations);
  };
  for (const std::size_t shared : {1U, 2U, 3U}) {
    EXPECT_NEAR(sixfold(shared).scale, 6.0, 1.0) << shared;
    EXPECT_GT(sixfold(shared).freedom, 0.0) << shared;
  }
  for (const std::size_t shared : {5U, 20U}) EXPECT_EQ(sixfold(shared).scale, 4.0) << "as a movement is, " << shared;
}

TEST(ShownErrors, AScaleFromResidualsIsKnownByAsManyAsTheBiweightUses) {
  EXPECT_EQ(shownErrors(scattered(28, 1.15)).freedom, 0.0) << "the given sigmas stand";
  EXPECT_NEAR(shownErrors(scattered(28, 1.35)).freedom, 0.87 * 25.0, 1e-9);
  EXPECT_EQ(shownErrors(scattered(8, 2.0)).freedom, 0.87 * 5.0);
}

TEST(ShownErrors, AnArcThatIsLearntIsKnownByAsManyAsAreIndependent) {
  const MovementErrors none = shownErrors(differences(360, 1, 3));
  EXPECT_EQ(none.shared, 0.0);
  EXPECT_EQ(none.freedom_whole, 0.0);
  const MovementErrors learnt = shownErrors(differences(360, 20, 3));
  ASSERT_GT(learnt.shared, 10.0 * kDegree);
  EXPECT_NEAR(learnt.freedom_whole, 0.87 * (kTwoPi / learnt.shared - 3.0), 1e-9);
  const MovementErrors scaled = shownErrors(scattered(28, 1.35));
  EXPECT_EQ(scaled.freedom_whole, scaled.freedom) << "the scale is learnt, and no arc";
}

TEST(ShownErrors, ThirtyTwoStationsTellTheArcThatNeighboursShare) {
  int told = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(shownErrors(differences(30, 5, seed)).shared, 0.0);
    told += shownErrors(differences(36, 5, seed)).shared > 10.0 * kDegree ? 1 : 0;
  }
  EXPECT_GE(told, 10);
}

TEST(ShownErrors, AnArcIsGivenAQuarterMore) {
  auto stations = differences(360, 1, 1, 0.0);
  for (MatchedStation& m : stations) m.dz = 0.010 * std::sin(6.0 * m.direction);
  // correlations of stations k degrees apart are cos(6 k), above 0.35 up to k = 11: their sum is 8.42
  EXPECT_NEAR(shownErrors(stations).shared / kDegree, 1.25 * (1.0 + 2.0 * 8.42), 1.0);
}

TEST(ShownErrors, ACorrelationOfAQuarterIsNone) {
  int shared = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto stations = differences(360, 1, seed, 0.001 * std::sqrt(0.75));
    const auto wide = differences(360, 30, 100 + seed, 0.001 * std::sqrt(0.25));
    for (std::size_t i = 0; i < stations.size(); ++i) stations[i].dz += wide[i].dz;
    shared += shownErrors(stations).shared > 0.0 ? 1 : 0;
  }
  EXPECT_LE(shared, 5);
}

TEST(WidenErrors, TakesTheLargerAndTheDeclaredArc) {
  auto stations = differences(8, 1, 1);
  widenErrors(stations, {2.0, 2.0, 10.0 * kDegree, 0.0}, 0.0);
  EXPECT_NEAR(stations[0].sigma, 0.002, 1e-12);
  EXPECT_NEAR(stations[0].window, 10.0 * kDegree, 1e-12);
  widenErrors(stations, {1.0, 0.5, 0.0, 0.0}, 30.0 * kDegree);
  EXPECT_NEAR(stations[0].sigma, 0.002, 1e-12);
  EXPECT_NEAR(stations[0].window, 30.0 * kDegree, 1e-12);
}

}  // namespace tank_datum::movement_errors_test
