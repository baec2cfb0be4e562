#include "shape/local_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/deviates.h"
#include "fit/harmonics.h"
#include "shape/analysis.h"
#include "shape/ring_model.h"
#include "support/made_surveys.h"

namespace tank_datum::local_shapes_test {

using made_surveys::kTurn;
using made_surveys::noisy;
using made_surveys::survey;
using made_surveys::takeTilt;
using made_surveys::wave;

constexpr double kSigma = 2e-4;

double bell(double azimuth, double centre, double deviation) {
  return std::exp(-0.5 * std::pow(std::remainder(azimuth - centre, kTurn) / deviation, 2.0));
}

double foundation(double a) {
  return 0.004 * std::cos(2 * a) + 0.002 * std::sin(3 * a) + 0.001 * std::cos(5 * a + 1.0);
}

Analysis analysed(const std::vector<double>& z, double sigma) {
  auto stations = survey(z, 30.0, sigma);
  const Tilt tilt = takeTilt(stations, {0.0, 0.0}, {});
  return analyse({stations, tilt, 30.0}, AnalysisOptions());
}

/// Errors that neighbours share over some degrees: a chain of the second order in both directions, made periodic.
std::vector<double> sharedErrors(double sigma, double degrees, std::uint64_t seed) {
  Deviates normal(seed);
  std::vector<double> errors(360, 0.0);
  for (int n = 0; n <= 180; ++n) {
    const double power = std::pow(3.0 / std::pow(degrees * kDegree, 2.0) + n * n, -1.0);
    const double a = normal(), b = normal();
    for (int i = 0; i < 360; ++i)
      errors[static_cast<std::size_t>(i)] += power * (a * std::cos(n * i * kDegree) + b * std::sin(n * i * kDegree));
  }
  double squares = 0.0;
  for (const double e : errors) squares += e * e / 360.0;
  for (double& e : errors) e *= sigma / std::sqrt(squares);
  return errors;
}

TEST(LocalShape, ItsWavesAddUpToIt) {
  const LocalShape shape{1.0, 20.0 * kDegree, 1.0, false};
  const Eigen::VectorXd waves = shape.waves(300);
  for (const double a : {0.6, 0.9, 1.0, 1.2, 3.0})
    EXPECT_NEAR(harmonicRows(Eigen::VectorXd::Constant(1, a), 300).row(0) * waves, shape.at(a), 1e-4);
  EXPECT_DOUBLE_EQ(shape.at(1.0), 1.0);
  EXPECT_NEAR(shape.at(1.0 + 10.0 * kDegree), 0.5, 1e-12);
  EXPECT_EQ(shape.at(1.0 + 21.0 * kDegree), 0.0);
}

TEST(LocalShape, HasTheWaveWhoseHalfLengthIsItsOwn) {
  const LocalShape shape{0.0, kTurn / 8.0, 1.0, false};  // n half_width = pi for n = 4
  EXPECT_NEAR(shape.waves(4)[7], 0.125, 1e-9);
}

TEST(LocalShape, IsLookedForAllRoundWhateverTheOrderOfAzimuths) {
  Eigen::VectorXd from_zero(360), from_half_a_turn(360);
  for (Eigen::Index i = 0; i < 360; ++i) {
    from_zero[i] = static_cast<double>(i) * kDegree;
    from_half_a_turn[i] = static_cast<double>(i < 180 ? i : i - 360) * kDegree;
  }
  const auto expected = candidateShapes(from_zero, from_zero),
             found = candidateShapes(from_half_a_turn, from_half_a_turn);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_NEAR(std::remainder(found[k].shape.centre - expected[k].shape.centre, kTurn), 0.0, 1e-12);
    double sum = 0.0, expected_sum = 0.0;
    for (const double value : found[k].values) sum += value;
    for (const double value : expected[k].values) expected_sum += value;
    EXPECT_NEAR(sum, expected_sum, 1e-9);
  }
}

TEST(LocalShape, IsLookedForAtTheSamePlacesWhicheverWayStationsAreCounted) {
  Eigen::VectorXd directions(200), azimuths(200);
  for (Eigen::Index i = 0; i < 200; ++i) {
    directions[i] = static_cast<double>(i + (i > 90 ? 100 : 0)) * kDegree;
    azimuths[i] = std::fmod(500.0 * kDegree - directions[i], kTurn);
  }
  const auto expected = candidateShapes(directions, directions), found = candidateShapes(azimuths, directions);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double there = 500.0 * kDegree - expected[k].shape.centre;
    EXPECT_NEAR(std::remainder(found[k].shape.centre - there, kTurn), 0.0, 1e-12);
  }
}

TEST(LocalSettlements, ADipIsPartOfTheDatumAndNotAnErrorOfNeighbours) {
  int covered = 0;
  for (const double deviation : {1.5, 3.0, 8.0}) {
    const std::vector<double> truth =
        wave(360, [&](double a) { return foundation(a) - 0.01 * bell(a, 2.0, deviation * kDegree); });
    double largest = 0.0;
    for (const Station& s : survey(truth, 30.0)) largest = std::max(largest, std::abs(s.u));
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Analysis analysis = analysed(noisy(truth, kSigma, seed), kSigma);
      const Interval95 u = analysis.out_of_plane.u_interval;
      covered += u.low <= largest && largest <= u.high ? 1 : 0;
      EXPECT_LT(u.high - u.low, 0.0015) << deviation;
      double lowest = 0.0, where = 0.0;
      for (const LocalSettlement& s : analysis.local_settlements) {
        if (s.height < lowest) lowest = s.height, where = s.azimuth;
      }
      EXPECT_NEAR(lowest, -0.01, 0.0035) << deviation;  // waves take part of a wide one
      EXPECT_NEAR(where, 2.0, deviation * kDegree);
    }
  }
  EXPECT_GE(covered, 26);  // of 30; binomial(30, 0.05) leaves five out once in 60
}

TEST(LocalSettlements, ASingleStationFarBelowTheOthersCounts) {
  std::vector<double> z = noisy(wave(360, foundation), kSigma, 4);
  z[100] -= 0.01;
  const Analysis analysis = analysed(z, kSigma);
  ASSERT_EQ(analysis.local_settlements.size(), 1u);
  EXPECT_NEAR(analysis.local_settlements[0].height, -0.01, 3 * kSigma);
  EXPECT_NEAR(analysis.local_settlements[0].azimuth, 100 * kDegree, 1e-9);
  EXPECT_GT(analysis.out_of_plane.u_interval.low, 0.006);
}

/// A dip that is no single cosine's bell takes several of them.
TEST(LocalSettlements, OnePlaceIsToldOnce) {
  for (const double half_width : {6.0 * kDegree, 12.0 * kDegree}) {
    const auto dip = [&](double a) {
      const double off = std::abs(std::remainder(a - 3.5, kTwoPi)) / half_width;
      return foundation(a) - (off < 1.0 ? 0.012 * (1.0 - off * off) * (1.0 - off * off) : 0.0);
    };
    const Analysis analysis = analysed(noisy(wave(360, dip), kSigma, 3), kSigma);
    ASSERT_EQ(analysis.local_settlements.size(), 1u) << half_width;
    EXPECT_NEAR(analysis.local_settlements[0].azimuth, 3.5, 0.15 * half_width);
    EXPECT_NEAR(analysis.local_settlements[0].width, 2.0 * half_width, 0.6 * half_width);
    EXPECT_NEAR(analysis.local_settlements[0].height, -0.012, 0.003);
  }
}

TEST(LocalSettlements, ShapesJoinFromTheFirstsBeginningToTheLastsEnd) {
  const LocalShape joined = LocalShape{0.1, 0.2, 1.0, false}.joinedWith({kTwoPi - 0.1, 0.3, 2.0, false});
  EXPECT_NEAR(std::remainder(joined.centre - -0.05, kTwoPi), 0.0, 1e-12);
  EXPECT_NEAR(joined.half_width, 0.35, 1e-12);
}

TEST(LocalSettlements, SeveralDipsDoNotHideEachOther) {
  const auto shape = [](double a) {
    double z = foundation(a);
    for (const double at : {0.5, 2.0, 3.2, 5.0}) z -= 0.006 * bell(a, at, 3.0 * kDegree);
    return z;
  };
  const Analysis analysis = analysed(noisy(wave(360, shape), kSigma, 5), kSigma);
  for (const double at : {0.5, 2.0, 3.2, 5.0}) {
    EXPECT_TRUE(std::any_of(analysis.local_settlements.begin(), analysis.local_settlements.end(),
                            [at](const LocalSettlement& s) { return std::abs(s.azimuth - at) < 0.05; }))
        << at;
  }
}

TEST(LocalSettlements, ErrorsThatNeighboursShareAreNone) {
  int found = 0;
  for (const double degrees : {5.0, 20.0}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      std::vector<double> z = noisy(wave(360, foundation), kSigma, static_cast<unsigned>(seed));
      const std::vector<double> shared = sharedErrors(0.001, degrees, seed);
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += shared[i];
      found += static_cast<int>(analysed(z, kSigma).local_settlements.size());
    }
  }
  EXPECT_LE(found, 2);
}

TEST(LocalSettlements, WavesAndNoiseAloneHaveNone) {
  int found = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
    found += static_cast<int>(analysed(noisy(wave(360, foundation), 0.001, seed), 0.001).local_settlements.size());
  EXPECT_LE(found, 1);
}

}  // namespace tank_datum::local_shapes_test
