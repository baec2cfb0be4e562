// The datum's highest, lowest and mean elevation, and its largest difference across a diameter.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "support/made_surveys.h"

namespace tank_datum::level_test {

using made_surveys::survey;

TEST(LevelOf, KnowsHighestLowestMeanAndTheirAzimuths) {
  const Level level = levelOf(survey({1, 4, 2, 2, -3, 2, 2, 2}, 10.0));
  EXPECT_EQ(level.measured, 8U);
  EXPECT_DOUBLE_EQ(level.mean, 1.5);
  EXPECT_EQ(level.max, 4);
  EXPECT_EQ(level.min, -3);
  EXPECT_EQ(level.range(), 7);
  EXPECT_DOUBLE_EQ(level.max_azimuth, 45 * kDegree);
  EXPECT_DOUBLE_EQ(level.min_azimuth, 180 * kDegree);
}

TEST(LevelOf, CountsFlagsAndPassesOverTheMissing) {
  auto stations = survey({NAN, 4, 2, 3, NAN, 3, 3, 3}, 10.0);
  stations[1].flag = StationFlag::Interpolated;
  const Level level = levelOf(stations);
  EXPECT_EQ(level.measured, 5U);
  EXPECT_EQ(level.interpolated, 1U);
  EXPECT_EQ(level.missing, 2U);
  EXPECT_DOUBLE_EQ(level.mean, 3.0);
  EXPECT_EQ(level.max, 4);
  EXPECT_EQ(level.min, 2);
}

TEST(LevelOf, NothingIsUnknown) {
  for (const auto& stations : {std::vector<Station>(), emptyStations({})}) {
    const Level level = levelOf(stations);
    EXPECT_TRUE(std::isnan(level.mean) && std::isnan(level.min) && std::isnan(level.max_azimuth));
    EXPECT_EQ(level.missing, stations.size());
  }
}

TEST(Antipodal, AngleOfThePaper) {  // STANDARDS 4.3
  const auto angle = [](double h) { return Antipodal{h, 60.0, 0.0}.angle() / kDegree; };
  EXPECT_NEAR(angle(0.015) * 3600, 51.6, 0.05);
  EXPECT_NEAR(angle(0.15), 0.1432, 5e-5);
}

TEST(AntipodalOf, IsTheLargestDifferenceAcrossADiameterSeenFromTheHigherEnd) {
  const Antipodal result = antipodalOf(survey({0, 0.1, 0, 0, 0.3, 0.2, 0, -0.25}, 30.0));
  EXPECT_NEAR(result.max_h, 0.3, 1e-15);  // 4 against 0; 3 against 7 makes 0.25
  EXPECT_NEAR(result.diameter, 60.0, 1e-12);
  EXPECT_DOUBLE_EQ(result.azimuth, 180 * kDegree);
  EXPECT_NEAR(result.angle(), std::atan(0.005), 1e-12);
}

TEST(AntipodalOf, LeavesOutPairsWithAMissingEnd) {
  const Antipodal result = antipodalOf(survey({NAN, 0.1, 0, 0, 0.3, 0.2, 0, -0.25}, 30.0));
  EXPECT_NEAR(result.max_h, 0.25, 1e-15);
  EXPECT_DOUBLE_EQ(result.azimuth, 135 * kDegree);
}

TEST(AntipodalOf, AStationNeedNotHaveOneAcross) {
  std::vector<Station> stations = survey({0, 0.1, 0, 0, 0.3, 0.2, 0, -0.25}, 30.0);
  stations.erase(stations.begin() + 4);
  EXPECT_NEAR(antipodalOf(stations).max_h, 0.25, 1e-15);
  EXPECT_EQ(antipodalHeights(stations).size(), 3U);
  std::rotate(stations.begin(), stations.begin() + 2, stations.end());
  EXPECT_NEAR(antipodalOf(stations).max_h, 0.25, 1e-15);
}

TEST(AntipodalOf, HasTheErrorsOfItsTwoEnds) {
  std::vector<Station> stations = survey({0, 0, 0, 0, 0.3, 0, 0, 0}, 30.0);
  EXPECT_TRUE(std::isnan(antipodalOf(stations).sigma));
  for (Station& s : stations) s.sigma_z = 0.001;
  stations[4].sigma_z = 0.002;
  EXPECT_NEAR(antipodalOf(stations).sigma, 0.002236, 1e-6);
}

TEST(AntipodalOf, IsUnknownForAnOddCountOrNoPair) {
  EXPECT_TRUE(std::isnan(antipodalOf(survey({1, 2, 3, 4, 5, 6, 7, 8, 9}, 30.0)).max_h));
  EXPECT_TRUE(std::isnan(antipodalOf(survey({1, 2, 3, 4, NAN, NAN, NAN, NAN}, 30.0)).max_h));
  EXPECT_TRUE(std::isnan(antipodalOf({}).angle()));
}

}  // namespace tank_datum::level_test
