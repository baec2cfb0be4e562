#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "setups/setup_shares.h"
#include "stations/stations.h"

namespace tank_datum::setup_share_bounds_test {

constexpr double kRadius = 10.0, kReach = 0.5;

std::vector<Station> stationsRound(int count, double window) {
  StationOptions options;
  options.count = count;
  std::vector<Station> stations = emptyStations(options);
  for (Station& s : stations) {
    s.flag = StationFlag::Measured;
    s.z = 0.0, s.sigma_z = 0.0003, s.radius = kRadius, s.window = window;
    s.x = kRadius * std::cos(s.direction), s.y = kRadius * std::sin(s.direction);
  }
  return stations;
}

/// Shares at station 0 of two setups that see it, the second at one place alone.
SetupShares sharesWith(double azimuth, double d, double h, double noise = 0.0, int stations = 36) {
  Ring ring;
  ring.reach = kReach;
  ring.setups = {{0, 0}, {1, 0}};
  const auto add = [&](double a, double out, double z, std::uint16_t setup) {
    ring.points.push_back({(kRadius + out) * std::cos(a), (kRadius + out) * std::sin(a), z});
    ring.point_setups.push_back(setup);
  };
  add(0.0, 0.1, 0.0, 0), add(0.0, 0.0, 0.3, 0);
  add(azimuth, d, h, 1);
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  return setupShares(ring, tank, stationsRound(stations, kTwoPi / 360.0), {0.0, 0.0}, {0.02, 0.25, 0.0, noise});
}

bool countsForFoundation(double h, double noise) { return sharesWith(0.0, 0.1, h, noise).foundation(0, 1) > 0.0; }

TEST(SetupShares, APointCountsWithinFiveNoisesAndAHundredthOfTheReachOfTheFoundation) {
  EXPECT_TRUE(countsForFoundation(0.0045, 0.0));
  EXPECT_FALSE(countsForFoundation(0.0055, 0.0));
  EXPECT_TRUE(countsForFoundation(0.0095, 0.001));
  EXPECT_FALSE(countsForFoundation(-0.0105, 0.001));
}

TEST(SetupShares, TheShellCountsFromATenthOfTheReachAboveTheDatum) {
  EXPECT_EQ(sharesWith(0.0, 0.0, 0.045).shell(0, 1), 0.0);
  EXPECT_GT(sharesWith(0.0, 0.0, 0.055).shell(0, 1), 0.0);
}

TEST(SetupShares, StationsTenDegreesApartCountTheDegreeTheyStandIn) {
  EXPECT_GT(sharesWith(toRadians(0.45), 0.1, 0.0).foundation(0, 1), 0.0);
  EXPECT_EQ(sharesWith(toRadians(0.60), 0.1, 0.0).foundation(0, 1), 0.0);
}

/// Shares of two setups, the second with so little of every station.
SetupShares sharesOf(std::size_t stations, double second) {
  SetupShares shares;
  shares.foundation = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(stations), 2, 1.0 - second);
  shares.foundation.col(1).setConstant(second);
  shares.shell = shares.foundation;
  return shares;
}

SetupAgreement agreementOf(double sigma) {
  SetupAgreement agreement;
  agreement.setups.resize(2);
  agreement.covariance = Eigen::MatrixXd::Zero(10, 10);
  agreement.covariance(0, 0) = sigma * sigma;
  return agreement;
}

TEST(ShareSetupErrors, ASetupSeesAStationFromOneHundredthOfItsPoints) {
  for (const double share : {0.008, 0.012}) {
    auto stations = stationsRound(36, 0.01);
    SetupAgreement agreement = agreementOf(0.002);
    const auto parts = shareSetupErrors(agreement, stations, sharesOf(36, share), 0.0).stations;
    EXPECT_EQ(parts[5].n_setups, share > 0.01 ? 2U : 1U);
  }
}

TEST(SetupFactors, WhatMovesNoStationByAThousandthOfAMillimetreIsLeftOut) {
  const auto stations = stationsRound(36, 0.01);
  EXPECT_EQ(setupFactors(agreementOf(0.8e-6), sharesOf(36, 0.0), stations, 0.0).rows(), 0);
  EXPECT_EQ(setupFactors(agreementOf(1.3e-6), sharesOf(36, 0.0), stations, 0.0).rows(), 1);
}

TEST(ShareSetupErrors, OfMergedScansAreWhatOneOfThemIsUncertainBy) {
  SetupAgreement agreement;
  agreement.merged_sigma = 0.003;
  EXPECT_NEAR(shareSetupErrors(agreement, stationsRound(36, 0.01), {}, 0.0).stations[5].sigma_setup, 0.003, 1e-9);
}

}  // namespace tank_datum::setup_share_bounds_test
