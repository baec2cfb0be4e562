#include "fit/harmonics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum::harmonics_test {

constexpr double kTurn = 6.283185307179586;

std::vector<double> turnOf(std::size_t count, double arc = kTurn) {
  std::vector<double> azimuths;
  for (std::size_t i = 0; i < count; ++i) azimuths.push_back(arc * static_cast<double>(i) / static_cast<double>(count));
  return azimuths;
}

double knownWave(double a) { return 2.0 + 0.5 * std::cos(a) - 0.25 * std::sin(2 * a) + 0.125 * std::cos(3 * a); }

std::vector<double> valuesAt(const std::vector<double>& azimuths, double (*wave)(double)) {
  std::vector<double> values;
  for (const double a : azimuths) values.push_back(wave(a));
  return values;
}

TEST(HarmonicRow, IsOneThenCosineAndSineOfEachOrder) {
  const Eigen::RowVectorXd row = harmonicRow(0.5, 2);
  ASSERT_EQ(row.size(), 5);
  EXPECT_EQ(row[0], 1.0);
  EXPECT_EQ(row[1], std::cos(0.5));
  EXPECT_EQ(row[2], std::sin(0.5));
  EXPECT_EQ(row[3], std::cos(1.0));
  EXPECT_EQ(row[4], std::sin(1.0));
  EXPECT_EQ(harmonicRow(0.5, 0).size(), 1);
}

TEST(FitHarmonics, OrderZeroIsTheMean) {
  const PeriodicFit fit = fitHarmonics({0.1, 0.2, 3.0}, {1, 2, 6}, {}, {0, false, 0.0});
  ASSERT_TRUE(fit.valid());
  EXPECT_EQ(fit.order(), 0);
  EXPECT_DOUBLE_EQ(fit(1.0), 3.0);
}

TEST(FitHarmonics, ReproducesAKnownWaveAndItsCoefficients) {
  const auto azimuths = turnOf(24);
  const PeriodicFit fit = fitHarmonics(azimuths, valuesAt(azimuths, knownWave), {}, {3, false, 0.0});
  const double expected[] = {2.0, 0.5, 0, 0, -0.25, 0.125, 0};
  ASSERT_EQ(fit.order(), 3);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(fit.coefficients[i], expected[i], 1e-12) << i;
  EXPECT_NEAR(fit(1.234), knownWave(1.234), 1e-12);
  EXPECT_NEAR(fit(1.234 + kTurn), knownWave(1.234), 1e-12);
}

TEST(FitHarmonics, KnownWaveFromHalfATurnOnly) {
  const auto azimuths = turnOf(200, kTurn / 2);
  const PeriodicFit fit = fitHarmonics(azimuths, valuesAt(azimuths, knownWave), {}, {3, false, 0.0});
  EXPECT_NEAR(fit(5.0), knownWave(5.0), 1e-8);
}

TEST(FitHarmonics, OfNothingIsNotValid) {
  EXPECT_FALSE(fitHarmonics({}, {}, {}, {2, true, 0.0}).valid());
  EXPECT_FALSE(PeriodicFit().valid());
}

TEST(FitHarmonics, WeightsDecideBetweenContradictingValues) {
  const std::vector<double> azimuths = {0, 0, 2, 2, 4, 4}, values = {1, 3, 1, 3, 1, 3};
  EXPECT_NEAR(fitHarmonics(azimuths, values, {}, {1, false, 0.0})(1.0), 2.0, 1e-12);
  EXPECT_NEAR(fitHarmonics(azimuths, values, {3, 1, 3, 1, 3, 1}, {1, false, 0.0})(1.0), 1.5, 1e-12);
  EXPECT_NEAR(fitHarmonics(azimuths, values, {0, 1, 0, 1, 0, 1}, {1, false, 0.0})(1.0), 3.0, 1e-12);
}

TEST(FitHarmonics, RobustLeavesGrossErrorsOut) {
  const auto azimuths = turnOf(100);
  auto values = valuesAt(azimuths, knownWave);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.001);
  for (double& v : values) v += noise(random);
  for (std::size_t i = 0; i < 100; i += 5) values[i] += 1.0;
  const PeriodicFit plain = fitHarmonics(azimuths, values, {}, {3, false, 0.0});
  const PeriodicFit robust = fitHarmonics(azimuths, values, {}, {3, true, 0.0});
  EXPECT_GT(plain(azimuths[50]) - knownWave(azimuths[50]), 0.1);
  EXPECT_NEAR(robust(azimuths[50]), knownWave(azimuths[50]), 0.002);
  EXPECT_NEAR(robust.sigma, 0.001, 0.0005);
}

TEST(FitHarmonics, RobustStillWeighs) {
  const std::vector<double> azimuths = {0, 0, 2, 2, 4, 4}, values = {1, 1.2, 1, 1.3, 1, 1.1};
  const double even = fitHarmonics(azimuths, values, {}, {0, true, 0.0})(0.0);
  const double lower = fitHarmonics(azimuths, values, {9, 1, 9, 1, 9, 1}, {0, true, 0.0})(0.0);
  EXPECT_NEAR(even, 1.1, 0.03);
  EXPECT_GT(lower, 1.0);
  EXPECT_LT(lower, 1.03);
}

TEST(FitHarmonics, RidgeKeepsTheWaveQuietAcrossAGap) {
  const auto azimuths = turnOf(60, 0.5 * kTurn);
  std::vector<double> values(60);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (double& v : values) v = 1.0 + noise(random);
  const double free = fitHarmonics(azimuths, values, {}, {6, false, 0.0})(0.75 * kTurn);
  const double quiet = fitHarmonics(azimuths, values, {}, {6, false, 1e-2})(0.75 * kTurn);
  EXPECT_GT(std::abs(free - 1.0), 0.5);
  EXPECT_NEAR(quiet, 1.0, 0.1);
}

TEST(FitHarmonics, RidgeFallsOnHighOrdersAndSparesTheMean) {
  const auto azimuths = turnOf(48);
  const auto values = valuesAt(azimuths, [](double a) { return 1.0 + std::cos(a) + std::cos(4 * a); });
  const PeriodicFit fit = fitHarmonics(azimuths, values, {}, {4, false, 1.0});
  EXPECT_NEAR(fit.coefficients[0], 1.0, 1e-12);
  EXPECT_NEAR(fit.coefficients[1], 0.5 / (0.5 + 1.0 / 256), 1e-12);  // half of the data's weight against (1/4)^4
  EXPECT_NEAR(fit.coefficients[7], 0.5 / (0.5 + 1.0), 1e-12);
}

TEST(FitHarmonics, CovarianceIsThatOfTheWeightedMean) {
  const PeriodicFit fit = fitHarmonics({0, 1, 2, 3}, {1, 1, 1, 1}, {4, 4, 4, 4}, {0, false, 0.0});
  ASSERT_EQ(fit.covariance.rows(), 1);
  EXPECT_DOUBLE_EQ(fit.covariance(0, 0), 1.0 / 16);
}

TEST(FitHarmonics, CovarianceForetellsTheScatterOfTheCoefficients) {
  const auto azimuths = turnOf(100);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.1);
  double squares = 0, foretold = 0;
  for (int run = 0; run < 400; ++run) {
    std::vector<double> values(100);
    for (double& v : values) v = noise(random);
    const PeriodicFit fit = fitHarmonics(azimuths, values, std::vector<double>(100, 100.0), {2, false, 0.0});
    squares += fit.coefficients[3] * fit.coefficients[3] / 400;
    foretold = fit.covariance(3, 3);
  }
  EXPECT_NEAR(squares / foretold, 1.0, 0.25);
}

}  // namespace tank_datum::harmonics_test
