#include "movement/ring_pairs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "movement/movement_errors.h"
#include "support/made_differences.h"
#include "support/made_epochs.h"

namespace tank_datum::ring_pairs_test {

using made_differences::differences;
using made_epochs::Survey;
using made_epochs::with;

/// How much of a sector's settlement a place has whose edges are so steep: all of it, none, or between.
double sectorAt(double degrees, double width, double ramp) {
  return std::clamp((0.5 * (width + ramp) - std::abs(degrees)) / ramp, 0.0, 1.0);
}

std::vector<double> valuesOf(const std::vector<MatchedStation>& stations) {
  std::vector<double> values;
  for (const MatchedStation& m : stations) values.push_back(m.dz / m.sigma);
  return values;
}

TEST(RingPairs, ASectorThatMovedIsNoError) {
  for (const double width : {60.0, 90.0, 120.0}) {
    for (const double moved : {0.008, 0.010, 0.020}) {
      auto stations = differences(360, 1, 5);
      for (std::size_t i = 0; i < 360; ++i)
        stations[i].dz -= moved * sectorAt(static_cast<double>(i) - 100.0, width, 5);
      const MovementErrors errors = shownErrors(stations);
      EXPECT_NEAR(errors.shown, 1.0, 0.2) << width << " " << moved;
      EXPECT_LT(errors.shared, 5.0 * kDegree) << width << " " << moved;
    }
  }
}

TEST(RingPairs, ASectorThatSettledIsFoundWhateverItsWidthAndDepth) {
  for (const double width : {20.0, 60.0, 90.0, 120.0}) {
    for (const double moved : {0.0015, 0.003, 0.005, 0.008}) {
      Survey first = with(&Survey::sigma, 0.0003, 2), second = with(&Survey::sigma, 0.0003, 3);
      Epoch later = second.epoch();
      for (std::size_t i = 0; i < 360; ++i)
        later.stations[i].z -= moved * sectorAt(static_cast<double>(i) - 100.0, width, 5);
      const Movement m = compareEpochs(first.epoch(), later, {});
      EXPECT_TRUE(m.moved()) << width << " " << moved;
      if (moved > 0.002) {
        EXPECT_TRUE(m.stations[100].significant) << width << " " << moved;
      }
    }
  }
}

/// Scatter by the pairs over that of all values, of stations side by side of which every other run of 15 moved.
double scatterOfArc(std::size_t count) {
  auto stations = differences(360, 1, 5, 0.0001);
  stations.resize(count);
  for (std::size_t i = 0; i < count; ++i) stations[i].dz += i / 15 % 2 == 0 ? 0.0005 : -0.0005;
  const std::vector<double> values = valuesOf(stations);
  return RingPairs(stations).scatterOf(values) / biweightSigma(values);
}

TEST(RingPairs, AreHeardWhereAThirdOfTheStationsHaveOne) {
  EXPECT_EQ(scatterOfArc(42), 1.0);  // 12 pairs
  EXPECT_LT(scatterOfArc(50), 0.5);  // 20
}

TEST(RingPairs, StepIsThatOfNeighboursWhateverTheGaps) {
  auto stations = differences(360, 1, 1);
  stations.resize(100);
  EXPECT_NEAR(RingPairs(stations).step(), 1.0 * kDegree, 1e-12);
  EXPECT_EQ(RingPairs(stations).widest(), 30U);
  for (std::size_t i = 0; i < 100; ++i) stations[i].direction = 0.1 * kDegree * static_cast<double>(i);
  EXPECT_EQ(RingPairs(stations).widest(), 99U) << "all within ten degrees";
  for (MatchedStation& m : stations) m.direction = 0.0;
  EXPECT_EQ(RingPairs(stations).widest(), 99U) << "all at one place";
  stations.resize(31);
  EXPECT_EQ(RingPairs(stations).widest(), 0U);
}

}  // namespace tank_datum::ring_pairs_test
