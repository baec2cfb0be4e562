#include "shape/ring_likelihood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::ring_likelihood_test {

/// What many stations without errors say: the squares of the waves' amplitudes from n = 2 on.
RingPriors priorsFrom(const std::vector<double>& squares, const RingHyperprior& hyperprior, double weight = 1e16) {
  const int order = 1 + static_cast<int>(squares.size());
  const Eigen::Index size = 2 * order + 1;
  Eigen::VectorXd waves = Eigen::VectorXd::Zero(size);
  for (std::size_t k = 0; k < squares.size(); ++k) waves[3 + 2 * static_cast<Eigen::Index>(k)] = std::sqrt(squares[k]);
  const Eigen::MatrixXd normal = weight * Eigen::MatrixXd::Identity(size, size);
  const Eigen::VectorXd rhs = weight * waves;
  return likeliestPriors({normal, rhs, 0.0, 360, order, 1.0}, hyperprior).first;
}

TEST(LikeliestPriors, WithoutDataAreTheUsualOnes) {
  const RingPriors priors = priorsFrom({0.0, 0.0}, {0.001, 0.005, 0.0}, 1e-9);
  EXPECT_NEAR(std::log(priors.amplitude / 0.005), 0.0, 0.2);
  EXPECT_NEAR(priors.power, 2.0, 0.2);
  EXPECT_NEAR(std::log(priors.length / toRadians(8.0)), 0.0, 0.2);
}

TEST(LikeliestPriors, AnAmplitudeIsKnownBeforehandToAFactorOfTwo) {
  // -2 ln of the density of one wave of amplitude a e^d: 4 d + X / e^(2d) with X = square / a^2, and (d / 0.7)^2
  constexpr double kWave = 0.003, kDeviation = 0.7;
  for (const double d : {-0.7, 0.7}) {
    const double amplitude = kWave * std::exp(d), x = 2.0 + d / (kDeviation * kDeviation);
    const RingPriors priors = priorsFrom({x * amplitude * amplitude}, {0.001, kWave, {}});
    EXPECT_NEAR(std::log(priors.amplitude / amplitude), 0.0, 0.15) << d;
    EXPECT_EQ(priors.neighbours, 0.0);
  }
}

TEST(LikeliestPriors, AUsualWaveIsFoundHoweverFarItStandsAboveTheErrors) {
  constexpr double kWave = 0.003;
  for (const double times : {1e1, 1e2, 1e3, 1e4}) {
    const RingPriors priors = priorsFrom({2.0 * kWave * kWave}, {kWave / times, kWave, {}});
    EXPECT_NEAR(std::log(priors.amplitude / kWave), 0.0, 0.15) << times;
  }
}

TEST(LikeliestPriors, APowerIsKnownBeforehandToThreeQuarters) {
  // n = 2 has four times the square of its amplitude, n = 3 nothing: ln(3/2) 4 = 2 (power - 2) / 0.75^2
  constexpr double kWave = 0.003;
  const RingPriors priors = priorsFrom({4.0 * kWave * kWave, 0.0}, {0.001, kWave, {}});
  EXPECT_NEAR(std::log(priors.amplitude / kWave), 0.0, 0.15);
  EXPECT_NEAR(priors.power, 2.0 + 2.0 * std::log(1.5) * 0.75 * 0.75, 0.15);
}

TEST(ErrorVariances, OfAllWavesAreTheErrorsVariance) {
  // the sum over all n of (c^2 + n^2)^-2 is pi / (2 c^3) for lengths that are short against the turn, c^2 = 3 /
  // length^2
  const double length = toRadians(2.0), c = std::sqrt(3.0) / length;
  const Eigen::VectorXd variances = errorVariances({0.0, 2.0, 0.001, length}, 45);
  EXPECT_NEAR(variances[0], 1e-6 / std::pow(c, 4) / (kPi / 2.0 / std::pow(c, 3)), 2e-3 * variances[0]);
  EXPECT_NEAR(variances[61], 2.0 * 1e-6 / std::pow(c * c + 31.0 * 31.0, 2) / (kPi / 2.0 / std::pow(c, 3)),
              2e-3 * variances[61]);
}

TEST(WaveVariances, FallWithThePower) {
  const Eigen::VectorXd variances = waveVariances({0.004, 1.5, 0.0, 0.1}, 8);
  EXPECT_EQ(variances.head<3>(), Eigen::Vector3d::Zero());
  EXPECT_NEAR(variances[3], 1.6e-5, 1e-12);
  EXPECT_NEAR(variances[16], 1.6e-5 / std::pow(4.0, 3.0), 1e-12);
}

}  // namespace tank_datum::ring_likelihood_test
