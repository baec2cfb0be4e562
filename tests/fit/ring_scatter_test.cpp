#include "fit/ring_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum::ring_scatter_test {

constexpr double kSigma = 0.0003;

/// Values that scatter by so many standard errors, each a mean of independent ones by these weights.
std::vector<double> scattered(double errors, std::size_t count, const std::vector<double>& weights = {1.0}) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> alone(count + weights.size()), values(count, 0.0);
  for (double& v : alone) v = normal(random);
  double squares = 0;
  for (const double w : weights) squares += w * w;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < weights.size(); ++k)
      values[i] += errors * kSigma * weights[k] / std::sqrt(squares) * alone[i + k];
  }
  return values;
}

double scatterOf(const std::vector<double>& values) {
  return ringScatter(values, std::vector<double>(values.size(), kSigma));
}

TEST(RingScatter, OfValuesThatErrAloneIsTheirs) {
  for (const double errors : {0.5, 1.0, 2.0}) EXPECT_NEAR(scatterOf(scattered(errors, 3600)), errors, 0.06 * errors);
}

TEST(RingScatter, WhatNeighboursShareCountsAsItDoesInMeansOfMany) {
  const std::vector<double> half = {2.0, 1.0};  // neighbours' correlation is 0.4
  EXPECT_NEAR(scatterOf(scattered(1.0, 3600, half)), std::sqrt(1.8), 0.05);
  EXPECT_NEAR(scatterOf(scattered(1.0, 360, half)), std::sqrt(1.8), 0.25);
}

TEST(RingScatter, OfNeighboursThatShareNoMoreThanChanceMakesOfItIsTheirs) {
  const std::vector<double> little = {1.0, 0.11};  // differences of neighbours are smaller by a twelfth
  EXPECT_LT(scatterOf(scattered(1.0, 500, little)), 1.0);
  EXPECT_GT(scatterOf(scattered(1.0, 600, little)), 1.05);
}

TEST(RingScatter, NeighboursAreTakenToShareHalfAtMost) {
  const double far = std::sqrt(1.0 - 1.5 * 0.1);  // correlation of those three apart
  EXPECT_NEAR(scatterOf(scattered(1.0, 3600, {1.0, std::sqrt(2.0), 1.0})), std::sqrt(2.0), 0.08);
  EXPECT_NEAR(scatterOf(scattered(1.0, 3600, {1.0, 2.0, 2.0, 1.0})), std::sqrt(2.0) * far, 0.05);
}

TEST(RingScatter, ADipOfAFewDegreesSaysLittle) {
  std::vector<double> values = scattered(1.0, 360);
  const double before = scatterOf(values);
  for (std::size_t i = 100; i < 112; ++i) values[i] -= 0.006 * std::sin(M_PI * (static_cast<double>(i) - 99.0) / 13.0);
  EXPECT_NEAR(scatterOf(values), before, 0.15 * before);
}

TEST(RingScatter, IsToldByFortyDifferences) {
  const auto of = [](std::size_t known) {
    std::vector<double> values = scattered(1.0, 360);
    for (std::size_t i = known; i < values.size(); ++i) values[i] = NAN;
    return scatterOf(values);
  };
  EXPECT_EQ(of(42), 0.0);
  EXPECT_GT(of(43), 0.0);
}

TEST(RingScatter, ValuesFourDegreesApartAreCloseEnough) {
  const auto ofEvery = [](std::size_t step) {
    std::vector<double> values = scattered(1.0, 360);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % step != 0) values[i] = NAN;
    }
    return scatterOf(values);
  };
  EXPECT_NEAR(ofEvery(4), 1.0, 0.25);
  EXPECT_EQ(ofEvery(5), 0.0);
}

}  // namespace tank_datum::ring_scatter_test
