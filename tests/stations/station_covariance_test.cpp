#include "stations/station_covariance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tank_datum::station_covariance_test {

std::vector<Station> stationsWith(const std::vector<double>& sigmas) {
  std::vector<Station> stations(sigmas.size());
  for (std::size_t i = 0; i < sigmas.size(); ++i) stations[i].sigma_z = sigmas[i];
  return stations;
}

TEST(StationCovariance, WithoutSharedErrorsIsTheSquaresOfTheStandardErrors) {
  const StationCovariance covariance = independentCovariance(stationsWith({0.001, 0.002, 0.003}));
  const Eigen::MatrixXd dense = covariance.dense({2, 0});
  EXPECT_DOUBLE_EQ(dense(0, 0), 9e-6);
  EXPECT_DOUBLE_EQ(dense(1, 1), 1e-6);
  EXPECT_DOUBLE_EQ(dense(0, 1), 0.0);
  EXPECT_DOUBLE_EQ(covariance.sigma(1), 0.002);
}

TEST(StationCovariance, ASharedErrorStandsInEveryPairThatHasIt) {
  StationCovariance covariance = independentCovariance(stationsWith({0.003, 0.003, 0.003}));
  covariance.factors.resize(1, 3);
  covariance.factors << 0.004, 0.004, 0.0;
  const Eigen::MatrixXd dense = covariance.dense({0, 1, 2});
  EXPECT_NEAR(dense(0, 0), 25e-6, 1e-18);
  EXPECT_NEAR(dense(0, 1), 16e-6, 1e-18);
  EXPECT_DOUBLE_EQ(dense(0, 2), 0.0);
  EXPECT_NEAR(covariance.sigma(0), 0.005, 1e-15);
  EXPECT_DOUBLE_EQ(covariance.sigma(2), 0.003);
}

TEST(StationCovariance, OfAnotherNumberOfStationsDoesNotFit) {
  const std::vector<Station> three = stationsWith({0.001, 0.001, 0.001});
  EXPECT_TRUE(fits({}, three));
  EXPECT_TRUE(fits(independentCovariance(three), three));
  EXPECT_FALSE(fits(independentCovariance(three), stationsWith({0.001})));
  StationCovariance unknown = independentCovariance(three);
  unknown.factors = Eigen::MatrixXd::Constant(1, 3, std::nan(""));
  EXPECT_FALSE(fits(unknown, three));
}

}  // namespace tank_datum::station_covariance_test
