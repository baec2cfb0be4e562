#include "stations/ring_series.h"

#include <gtest/gtest.h>

#include "support/made_surveys.h"

namespace tank_datum::ring_series_test {

using namespace made_surveys;

TEST(RingSeries, IsLinearBetweenNeighboursAndRoundTheTurn) {
  std::vector<double> z(36, 0.0);
  z[35] = 1.0, z[0] = 3.0;
  const RingSeries series(survey(z, 10.0, 0.1), &Station::z, &Station::sigma_z);
  EXPECT_NEAR(series.at(-5 * kDegree)->value, 2.0, 1e-9);
  EXPECT_NEAR(series.at(-5 * kDegree)->sigma, 0.1 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(series.at(0.0)->value, 3.0, 1e-12);
  EXPECT_NEAR(series.at(0.0)->sigma, 0.1, 1e-12);
  EXPECT_NEAR(series.at(kTurn * 3)->value, 3.0, 1e-12);
  EXPECT_NEAR(series.at(2.5 * kDegree)->value, 2.25, 1e-9);
}

TEST(RingSeries, IsSilentInAGap) {
  std::vector<double> z(36, 1.0);
  z[4] = NAN;
  const RingSeries series(survey(z, 10.0), &Station::z, &Station::sigma_z);
  EXPECT_FALSE(series.at(35 * kDegree).has_value());
  EXPECT_TRUE(series.at(30 * kDegree).has_value());
  EXPECT_TRUE(series.at(50 * kDegree).has_value());
  EXPECT_FALSE(RingSeries({}, &Station::z, &Station::sigma_z).at(0.0).has_value());
}

TEST(RingSeries, IsSilentBetweenStationsMoreThanTwiceTheMeanDistanceApart) {
  const auto joinedOver = [](double degrees) {
    auto stations = survey(std::vector<double>(36, 1.0), 10.0);
    stations[5].azimuth = stations[4].azimuth + degrees * kDegree;
    return RingSeries(stations, &Station::z, &Station::sigma_z).at(stations[4].azimuth + 1.0 * kDegree).has_value();
  };
  EXPECT_TRUE(joinedOver(19.8));
  EXPECT_FALSE(joinedOver(20.4));
}

TEST(RingSeries, AStationBesideAGapIsFoundToWithinTheRoundingOfItsAzimuth) {
  std::vector<double> z(36, 1.0);
  z[4] = z[6] = NAN;
  const RingSeries series(survey(z, 10.0), &Station::z, &Station::sigma_z);
  EXPECT_TRUE(series.at(50 * kDegree + 0.8e-9).has_value());
  EXPECT_TRUE(series.at(50 * kDegree - 0.8e-9).has_value());
  EXPECT_FALSE(series.at(50 * kDegree + 1.3e-9).has_value());
}

}  // namespace tank_datum::ring_series_test
