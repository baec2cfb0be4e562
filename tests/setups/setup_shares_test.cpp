#include "setups/setup_shares.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "core/units.h"
#include "stations/station_covariance.h"
#include "stations/stations.h"

namespace tank_datum::setup_shares_test {

constexpr double kRadius = 10.0;

/// A flat foundation round a tank: setup 0 sees azimuths 0 ... 200 degrees, setup 1 180 ... 360, as densely.
Ring madeRing() {
  Ring ring;
  ring.reach = 0.5;
  ring.setups = {{0, 0}, {1, 0}};
  for (int i = 0; i < 36000; ++i) {
    const double azimuth = (i + 0.5) * kTwoPi / 36000.0, d = 0.02 + 0.2 * ((i * 7) % 100) / 100.0;
    for (const int s : {0, 1}) {
      const bool seen = s == 0 ? azimuth < toRadians(200.0) : azimuth > toRadians(180.0);
      if (!seen) continue;
      ring.points.push_back({(kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), 0.0});
      ring.point_setups.push_back(static_cast<std::uint16_t>(s));
      ring.points.push_back({kRadius * std::cos(azimuth), kRadius * std::sin(azimuth), 0.3});
      ring.point_setups.push_back(static_cast<std::uint16_t>(s));
    }
  }
  return ring;
}

std::vector<Station> madeStations(bool clockwise = false, int count = 360) {
  StationOptions options;
  options.clockwise = clockwise;
  options.count = count;
  std::vector<Station> stations = emptyStations(options);
  for (Station& s : stations) {
    s.flag = StationFlag::Measured;
    s.z = 0.0;
    s.sigma_z = 0.0003;
    s.radius = kRadius;
    s.sigma_radius = 0.0004;
    s.x = kRadius * std::cos(s.direction);
    s.y = kRadius * std::sin(s.direction);
    s.window = kTwoPi / 360.0;
  }
  return stations;
}

Tank madeTank() {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  return tank;
}

const FoundationBand kBand{0.02, 0.25, 0.0, 0.001};

/// Heights unknown by 2 mm, nothing else.
SetupAgreement madeAgreement() {
  SetupAgreement agreement;
  agreement.setups.resize(2);
  agreement.covariance = Eigen::MatrixXd::Zero(10, 10);
  agreement.covariance(0, 0) = agreement.covariance(5, 5) = 4e-6;
  return agreement;
}

TEST(SetupShares, AreThoseOfTheFoundationsPoints) {
  for (const bool clockwise : {false, true}) {
    const auto stations = madeStations(clockwise);
    const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
    const auto at = [&](int degrees) { return clockwise ? (360 - degrees) % 360 : degrees; };
    EXPECT_DOUBLE_EQ(shares.foundation(at(90), 0), 1.0);
    EXPECT_DOUBLE_EQ(shares.foundation(at(270), 1), 1.0);
    EXPECT_NEAR(shares.foundation(at(190), 0), 0.5, 0.01);
    EXPECT_NEAR(shares.shell(at(190), 1), 0.5, 0.01);
    EXPECT_DOUBLE_EQ(shares.foundation(at(90), 1), 0.0);
  }
}

TEST(SetupShares, StationsFartherApartHaveTheirOwnWindow) {
  const SetupShares shares = setupShares(madeRing(), madeTank(), madeStations(false, 8), {0.0, 0.0}, kBand);
  EXPECT_DOUBLE_EQ(shares.foundation(2, 0), 1.0);
  EXPECT_DOUBLE_EQ(shares.foundation(6, 1), 1.0);
  EXPECT_NEAR(shares.foundation(4, 1), 0.33, 0.2);  // at 180 degrees the second begins
}

TEST(SetupShares, AnInterpolatedStationHasBothSides) {
  auto stations = madeStations();
  for (int i = 175; i <= 204; ++i) stations[static_cast<std::size_t>(i)].flag = StationFlag::Interpolated;
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  EXPECT_DOUBLE_EQ(shares.foundation(190, 0), 0.5);
  EXPECT_DOUBLE_EQ(shares.foundation(190, 1), 0.5);
}

TEST(SetupShares, AMeasuredStationWithoutAPointInTheBandHasBothSides) {
  auto stations = madeStations();
  for (const std::size_t i : {90U, 270U}) stations[i].z = 0.1;  // its points lie far off the band there
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  EXPECT_DOUBLE_EQ(shares.foundation(90, 0), 1.0);
  EXPECT_DOUBLE_EQ(shares.foundation(270, 1), 1.0);
  EXPECT_DOUBLE_EQ(shares.foundation(270, 0), 0.0);
}

TEST(SetupShares, ErrorsOfSetupsAreSharedByTheirStations) {
  auto stations = madeStations();
  stations[10].flag = StationFlag::Missing;
  stations[10].z = stations[10].sigma_z = std::nan("");
  SetupAgreement agreement = madeAgreement();
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  const auto [covariance, radius_errors, parts, seen] = shareSetupErrors(agreement, stations, shares, 0.0);
  EXPECT_NEAR(parts[90].sigma_setup, 0.002, 1e-9);
  EXPECT_NEAR(covariance.sigma(90), std::hypot(0.002, 0.0003), 1e-9);
  EXPECT_EQ(parts[90].n_setups, 1U);
  EXPECT_EQ(parts[190].n_setups, 2U);
  EXPECT_NEAR(parts[190].sigma_setup, 0.002 / std::sqrt(2.0), 2e-5);
  EXPECT_FALSE(parts[10].n_setups);
  const Eigen::MatrixXd dense = covariance.dense({80, 90, 270, 190});
  EXPECT_NEAR(dense(0, 1), 4e-6, 1e-9);  // one setup
  EXPECT_NEAR(dense(0, 2), 0.0, 1e-9);   // another
  EXPECT_NEAR(dense(1, 3), 2e-6, 4e-8);  // half of it
  EXPECT_NEAR(dense(0, 0), 4e-6 + 9e-8, 1e-9);
  EXPECT_EQ(covariance.factors.rows(), 2);
  EXPECT_EQ(covariance.factors.col(10).norm(), 0.0);
  EXPECT_TRUE(fits(covariance, stations));
  EXPECT_EQ(seen[0].size(), 200U);  // 0 ... 200 without station 10, the last seen by half of its window
}

TEST(SetupShares, ErrorsInPlanAreThoseOfRadiiFromTheCentreOfAll) {
  const auto stations = madeStations();
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  SetupAgreement agreement = madeAgreement();
  for (const double error : setupRadiusErrors(agreement, shares, stations)) EXPECT_EQ(error, 0.0);  // heights alone
  for (const int i : {3, 8}) {
    for (const int j : {3, 8}) agreement.covariance(i, j) = 4e-6;  // both together by 2 mm along x
  }
  for (const double error : setupRadiusErrors(agreement, shares, stations)) EXPECT_NEAR(error, 0.0, 1e-9);
  agreement.covariance(3, 3) = 0.0, agreement.covariance(3, 8) = agreement.covariance(8, 3) = 0.0;  // the second alone
  const std::vector<double> errors = setupRadiusErrors(agreement, shares, stations);
  Eigen::MatrixXd outwards(360, 2);
  Eigen::VectorXd moved(360);
  for (int i = 0; i < 360; ++i) {
    const double direction = stations[static_cast<std::size_t>(i)].direction;
    outwards.row(i) << std::cos(direction), std::sin(direction);
    moved[i] = 0.002 * shares.shell(i, 1) * outwards(i, 0);
  }
  moved -= outwards * outwards.colPivHouseholderQr().solve(moved);
  EXPECT_GT(moved.cwiseAbs().maxCoeff(), 0.0005);
  for (int i = 0; i < 360; ++i) EXPECT_NEAR(errors[static_cast<std::size_t>(i)], std::abs(moved[i]), 1e-9) << i;
}

TEST(SetupShares, ScansMergedWithoutLabelsErrInPlanAsInHeight) {
  const auto stations = madeStations();
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  SetupAgreement agreement;
  agreement.merged_sigma = 0.003;
  for (const double error : setupRadiusErrors(agreement, shares, stations)) EXPECT_EQ(error, 0.003);
  const auto known = withSharedErrors(stations, shareSetupErrors(agreement, stations, shares, 0.0));
  EXPECT_NEAR(known[90].sigma_z, std::hypot(0.003, 0.0003), 1e-9);
  EXPECT_NEAR(known[90].sigma_radius, std::hypot(0.003, 0.0004), 1e-9);
}

TEST(SetupShares, ATiltMovesStationsByTheirDistanceFromTheScanner) {
  auto stations = madeStations();
  SetupAgreement agreement = madeAgreement();
  agreement.covariance.setZero();
  agreement.covariance(1, 1) = 1e-8;
  agreement.setups[0].origin = {20.0, 0.0, 1.5};
  const SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  const auto parts = shareSetupErrors(agreement, stations, shares, 0.0).stations;
  EXPECT_NEAR(parts[90].sigma_setup, 1e-4 * 20.0, 1e-7);
  EXPECT_NEAR(parts[0].sigma_setup, 1e-4 * 10.0, 6e-4);
  EXPECT_NEAR(parts[270].sigma_setup, 0.0, 1e-12);
}

TEST(SetupShares, OnASlopingFoundationAShiftInPlanMovesOnlyWhatTheShellDoesNotShare) {
  const auto stations = madeStations();
  SetupAgreement agreement = madeAgreement();
  agreement.covariance.setZero();
  agreement.covariance(3, 3) = 1e-4;  // dx of the first, 10 mm
  SetupShares shares = setupShares(madeRing(), madeTank(), stations, {0.0, 0.0}, kBand);
  const Eigen::MatrixXd shared = setupFactors(agreement, shares, stations, 0.05);
  EXPECT_LT(shared.norm(), 0.05 * 0.010 * 0.2);  // the shell comes from the same setups, nearly as many points of each
  shares.shell.setZero();
  shares.shell.col(1).setOnes();
  EXPECT_NEAR(setupFactors(agreement, shares, stations, 0.05).col(1).norm(), 0.05 * 0.010, 1e-6);
}

TEST(SetupShares, OneSetupSharesNothing) {
  auto stations = madeStations();
  Ring ring = madeRing();
  ring.point_setups.clear();
  SetupAgreement agreement;
  agreement.setups.resize(1);
  agreement.setups[0].points = ring.points.size();
  const SetupShares shares = setupShares(ring, madeTank(), stations, {0.0, 0.0}, kBand);
  const auto [covariance, radius_errors, parts, seen] = shareSetupErrors(agreement, stations, shares, 0.0);
  EXPECT_EQ(covariance.factors.rows(), 0);
  EXPECT_EQ(parts[5].sigma_setup, 0.0);
  EXPECT_EQ(covariance.sigma(5), 0.0003);
  EXPECT_EQ(seen.size(), 1U);
  EXPECT_EQ(parts[5].n_setups, 1U);
}

TEST(ShareSetupErrors, OfSeveralSetupsOfWhichOneHasPointsThatOneSeesAll) {
  Ring ring = madeRing();
  ring.point_setups.clear();
  const auto stations = madeStations();
  SetupAgreement agreement;
  agreement.setups.resize(3);
  agreement.setups[1].points = ring.points.size();
  const SetupShares shares = setupShares(ring, madeTank(), stations, {0.0, 0.0}, kBand);
  const SharedErrors shared = shareSetupErrors(agreement, stations, shares, 0.0);
  EXPECT_TRUE(shared.seen[0].empty() && shared.seen[2].empty());
  EXPECT_EQ(shared.seen[1].size(), stations.size());
  for (const StationSetups& s : shared.stations) ASSERT_EQ(s.n_setups, 1U);
}

}  // namespace tank_datum::setup_shares_test
