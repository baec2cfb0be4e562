#include "shape/deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "stations/stations.h"
#include "support/made_surveys.h"

namespace tank_datum::deformation_test {

using made_surveys::takeTilt;

constexpr double kTurn = 6.283185307179586;
const Eigen::Vector2d kCenter(50.0, -20.0);

/// Measured stations of a tank about kCenter with these elevations.
std::vector<Station> survey(const std::vector<double>& z, double radius, StationOptions options = {}) {
  options.count = static_cast<int>(z.size());
  std::vector<Station> stations = emptyStations(options);
  for (std::size_t i = 0; i < z.size(); ++i) {
    Station& s = stations[i];
    s.z = z[i];
    s.radius = radius;
    s.x = kCenter.x() + radius * std::cos(s.direction);
    s.y = kCenter.y() + radius * std::sin(s.direction);
    s.flag = std::isnan(z[i]) ? StationFlag::Missing : StationFlag::Measured;
  }
  return stations;
}

std::vector<double> wave(std::size_t count, double (*z)(double)) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(z(kTurn * static_cast<double>(i) / static_cast<double>(count)));
  return values;
}

double tilted(double a) { return 2.0 + 0.03 * std::cos(a) + 0.04 * std::sin(a); }

TEST(FitTilt, OfSixteenStationsOfThePemyPaper) {  // STANDARDS 4.1, elevations in inches
  auto stations = survey(
      {-1.10, -1.42, -1.70, -1.73, -1.84, -1.63, -1.50, -0.80, 0.00, -0.54, -0.97, -0.90, -0.80, -1.05, -1.20, -1.17},
      60.0);
  const Tilt tilt = takeTilt(stations, kCenter, {});
  EXPECT_NEAR(tilt.mean, -1.1469, 5e-5);
  EXPECT_NEAR(60 * tilt.gradient.x(), -0.3318, 5e-5);
  EXPECT_NEAR(60 * tilt.gradient.y(), -0.4083, 5e-5);
  EXPECT_NEAR(60 * tilt.slope(), 0.5261, 5e-5);
  EXPECT_NEAR(tilt.r2, 0.6167, 5e-5);
  EXPECT_NEAR(tilt.p_value, 0.00196, 5e-5);
  EXPECT_NEAR(60 * tilt.sigma_slope, 0.3254 * std::sqrt(2.0 / 16), 5e-5);
}

TEST(FitTilt, OfFourteenStationsOfAnInspectionReport) {  // STANDARDS 4.2
  auto stations =
      survey({1.050, 1.030, 1.040, 0.980, 0.940, 0.940, 0.980, 1.040, 1.060, 1.065, 1.090, 1.120, 1.090, 1.060}, 21.03);
  const Tilt tilt = takeTilt(stations, kCenter, {});
  EXPECT_NEAR(21.03 * tilt.slope(), 0.07005, 5e-6);
  EXPECT_NEAR(tilt.r2, 0.862, 5e-4);
}

/// A 30 m tank seen over an arc, with waves of two to four lobes and noise; its tilt is 0.0004 towards 53 degrees.
std::vector<Station> seenOver(double arc_deg, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double radius = 30.0, tilt = 0.0004 * radius;
  double waves[6];
  for (int i = 0; i < 6; ++i) waves[i] = 0.5 * radius / 2000.0 * 4.0 / std::pow(2 + i / 2, 2) * normal(random);
  std::vector<double> z;
  for (int i = 0; i < 360; ++i) {
    const double a = i * kDegree;
    double height = tilt * (0.6 * std::cos(a) + 0.8 * std::sin(a)) + 0.0005 * normal(random);
    for (int n = 2; n <= 4; ++n) height += waves[2 * n - 4] * std::cos(n * a) + waves[2 * n - 3] * std::sin(n * a);
    z.push_back(i < arc_deg ? height : NAN);
  }
  std::vector<Station> stations = survey(z, radius);
  for (Station& s : stations) s.sigma_z = 0.0005;
  return stations;
}

TEST(FitTilt, BesideAGapKnowsWhatWavesMayHide) {
  std::mt19937_64 random(1);
  const Eigen::Vector2d truth(0.6 * 0.0004, 0.8 * 0.0004);
  for (const double arc : {90.0, 150.0, 240.0, 320.0}) {
    int within = 0;
    double sigma = 0.0;
    for (int run = 0; run < 50; ++run) {
      auto stations = seenOver(arc, random);
      const Tilt tilt = takeTilt(stations, kCenter, {});
      const Eigen::Vector2d along = tilt.gradient.normalized();
      within += std::abs(along.dot(tilt.gradient - truth)) <= 2.0 * tilt.sigma_slope;
      sigma += tilt.sigma_slope / 50;
    }
    EXPECT_GE(within, 43) << arc;
    EXPECT_GT(sigma, arc < 100.0 ? 1e-4 : 0.0) << arc;   // nothing is said of the tilt from a quarter of the ring
    EXPECT_LT(sigma, arc > 200.0 ? 4e-5 : 2e-3) << arc;  // and much from two thirds
  }
}

TEST(FitTilt, OfFewStationsAllRoundIsThePlainRegression) {
  auto eight = survey({1.05, 1.03, 1.04, 0.98, 0.94, 0.95, 0.98, 1.04}, 10.0);
  const Tilt tilt = takeTilt(eight, kCenter, {});
  double x = 0.0;
  for (const Station& s : eight) x += s.z * (s.x - kCenter.x()) / (4.0 * 100.0);
  EXPECT_NEAR(tilt.gradient.x(), x, 1e-12);
}

TEST(FitTilt, FindsAnExactPlane) {
  auto stations = survey(wave(36, tilted), 10.0);
  const Tilt tilt = takeTilt(stations, kCenter, {});
  ASSERT_TRUE(tilt.valid());
  EXPECT_NEAR(tilt.mean, 2.0, 1e-12);
  EXPECT_NEAR(tilt.slope(), 0.005, 1e-12);
  EXPECT_NEAR(tilt.direction, std::atan2(4, 3), 1e-9);
  EXPECT_NEAR(tilt.r2, 1.0, 1e-12);
  EXPECT_NEAR(tilt.p_value, 0.0, 1e-12);
  EXPECT_NEAR(tilt.sigma_slope, 0.0, 1e-8);  // elevations are known to 1e-5 of their scatter at best
  for (const Station& s : stations) {
    EXPECT_NEAR(s.z_tilt, s.z, 1e-12);
    EXPECT_NEAR(s.u, 0.0, 1e-12);
  }
}

TEST(FitTilt, LeavesHigherWavesToU) {
  auto stations = survey(wave(72, [](double a) { return tilted(a) + 0.01 * std::cos(3 * a); }), 10.0);
  EXPECT_NEAR(takeTilt(stations, kCenter, {}).slope(), 0.005, 1e-12);
  for (const Station& s : stations) EXPECT_NEAR(s.u, 0.01 * std::cos(3 * s.direction), 1e-12);
}

TEST(FitTilt, DirectionIsCountedAsTheStationsAre) {
  StationOptions north;
  north.zero_azimuth = 90 * kDegree;
  north.clockwise = true;
  std::vector<double> z;
  for (const Station& s : emptyStations(north)) z.push_back(0.02 * std::cos(s.direction));  // high in the east
  auto stations = survey(z, 10.0, north);
  EXPECT_NEAR(takeTilt(stations, kCenter, north).direction, 90 * kDegree, 1e-9);
  EXPECT_NEAR(std::remainder(takeTilt(stations, kCenter, {}).direction, kTurn), 0.0, 1e-9);
}

TEST(FitTilt, UsesMeasuredStationsOnlyAndDescribesInterpolatedOnes) {
  auto stations = survey(wave(36, tilted), 10.0);
  stations[5].flag = StationFlag::Interpolated;
  stations[5].z += 1.0;
  stations[9].flag = StationFlag::Missing;
  stations[9].z = NAN;
  EXPECT_NEAR(takeTilt(stations, kCenter, {}).slope(), 0.005, 1e-12);
  EXPECT_NEAR(stations[5].u, 1.0, 1e-12);
  EXPECT_TRUE(std::isnan(stations[9].u));
  EXPECT_TRUE(std::isnan(stations[9].z_tilt));
}

TEST(FitTilt, StandardErrorForetellsItsScatter) {
  double squares = 0, foretold = 0;
  unsigned state = 1;
  const auto uniform = [&] { return ((state = state * 1664525U + 1013904223U) >> 8) * 0x1.0p-24 - 0.5; };
  for (int run = 0; run < 500; ++run) {
    std::vector<double> z = wave(36, tilted);
    for (double& v : z) v += 0.01 * uniform();
    auto stations = survey(z, 10.0);
    const Tilt tilt = takeTilt(stations, kCenter, {});
    squares += std::pow(tilt.slope() - 0.005, 2) / 500;
    foretold += tilt.sigma_slope / 500;
  }
  EXPECT_NEAR(std::sqrt(squares) / foretold, 1.0, 0.1);
}

TEST(FitTilt, NeedsFourMeasuredStations) {
  std::vector<double> z(12, NAN);
  z[0] = z[4] = z[8] = 1.0;
  auto three = survey(z, 10.0);
  EXPECT_FALSE(takeTilt(three, kCenter, {}).valid());
  EXPECT_TRUE(std::isnan(three[0].u));
  z[2] = 1.1;
  auto four = survey(z, 10.0);
  EXPECT_TRUE(takeTilt(four, kCenter, {}).valid());
  std::vector<Station> none;
  EXPECT_FALSE(takeTilt(none, kCenter, {}).valid());
}

TEST(FitTilt, OfALevelDatumHasNoSlopeAndNoSignificance) {
  for (const double level : {0.0, 0.1, 100.3}) {
    auto stations = survey(std::vector<double>(360, level), 10.0);
    const Tilt tilt = takeTilt(stations, kCenter, {});
    EXPECT_NEAR(tilt.slope(), 0.0, 1e-12);
    EXPECT_FALSE(tilt.r2 < 0.0 || tilt.r2 > 1.0) << level << " " << tilt.r2;
    EXPECT_FALSE(tilt.p_value < 0.5 || tilt.p_value > 1.0) << level << " " << tilt.p_value;
  }
}

TEST(FitTilt, ExplainsNothingOfAnOval) {
  for (int order = 2; order < 9; ++order) {
    auto stations = survey(wave(360, [](double) { return 0.3; }), 10.0);
    for (Station& s : stations) s.z += 0.01 * std::cos(order * s.direction);
    const Tilt tilt = takeTilt(stations, kCenter, {});
    EXPECT_GE(tilt.r2, 0.0) << order;
    EXPECT_LT(tilt.r2, 1e-9) << order;
    EXPECT_LE(tilt.p_value, 1.0) << order;
    EXPECT_GT(tilt.p_value, 0.99) << order;
  }
}

/// Of a level ring with a gap of 30 degrees whose middle is at an azimuth: the standard error of the slope that is
/// known worst, where something was refused in the gap that lies so high.
double worstSigma(double refused, double middle_deg, bool clockwise = false) {
  StationOptions options;
  options.clockwise = clockwise;
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal(0.0, 0.0001);
  std::vector<double> z(360);
  for (double& v : z) v = normal(random);
  auto stations = survey(z, 10.0, options);
  for (Station& s : stations) {
    s.sigma_z = 0.0001;
    if (std::abs(std::remainder(s.azimuth - toRadians(middle_deg), kTurn)) > toRadians(15.5)) continue;
    s.flag = StationFlag::Missing, s.z = kUnknown, s.z_refused = refused;
  }
  const Eigen::Matrix2d covariance = takeTilt(stations, kCenter, options).covariance;
  return std::sqrt(covariance.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
}

TEST(FitTilt, HoldsInTwoStandardErrorsWhatWasRefusedInAGap) {
  const double half = toRadians(15.5);  // of an elevation of 1 over it the wave is 2 sin(half) / pi
  const double slope = 0.1 * 2.0 * std::sin(half) / kPi / 10.0;
  EXPECT_LT(worstSigma(kUnknown, 90.0), 0.01 * slope);
  for (const double middle : {0.0, 90.0, 217.0}) {
    for (const bool clockwise : {false, true})
      EXPECT_NEAR(worstSigma(-0.1, middle, clockwise), 0.5 * slope, 0.05 * slope) << middle;
  }
}

}  // namespace tank_datum::deformation_test
