#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "fit/harmonics.h"
#include "shape/ring_likelihood.h"
#include "shape/ring_model.h"
#include "support/made_surveys.h"

namespace tank_datum::ring_bounds_test {

using namespace made_surveys;

/// What many stations without errors say of the error that neighbours share, of this length: that each wave has its
/// variance, but the first has more by a share and the last less.
double lengthFound(double length, double share) {
  constexpr int kOrder = 5;
  constexpr double kNeighbours = 0.001, kWeight = 1e16;
  const Eigen::VectorXd variances = errorVariances({0.0, 2.0, kNeighbours, length}, kOrder);
  const Eigen::Index size = 2 * kOrder + 1;
  Eigen::VectorXd waves = Eigen::VectorXd::Zero(size);
  for (int n = 2; n <= kOrder; ++n) {
    const double more = n == 2 ? share : n == kOrder ? -share : 0.0;
    waves[2 * n - 1] = std::sqrt((2.0 + more) * variances[2 * n]);  // of two coefficients
  }
  const Eigen::MatrixXd normal = kWeight * Eigen::MatrixXd::Identity(size, size);
  const Eigen::VectorXd rhs = kWeight * waves;
  // waves of a nanometre: what is seen is error
  return likeliestPriors({normal, rhs, 0.0, 360, kOrder, 1.0}, {0.001, 1e-9, 0.0}).first.length;
}

TEST(LikeliestPriors, ALengthIsKnownBeforehandToAFactorOfTwoAndAQuarter) {
  // the slope of -2 ln of the likelihood against ln length, (g2 - g5) share with g = 12 / l^2 / (3 / l^2 + n^2), is
  // that of ((ln l - ln 8 degrees) / 0.8)^2
  const double length = toRadians(16.0), c = 3.0 / (length * length);
  const double share = 2.0 * std::log(2.0) / (0.8 * 0.8) / (4.0 * c / (c + 4.0) - 4.0 * c / (c + 25.0));
  EXPECT_NEAR(std::log(lengthFound(length, share) / length), 0.0, 0.15);
}

TEST(RingModel, LooksForEightLocalSettlementsAtMost) {
  const std::vector<double> at = {5.0, 38.0, 81.0, 109.0, 152.0, 190.0, 221.0, 262.0, 301.0, 333.0};
  const auto dips = [&](double a) {
    double z = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      const double off = std::remainder(a / kDegree - at[k], 360.0) / (3.0 + 0.3 * static_cast<double>(k));
      if (std::abs(off) < 1.0) z -= (0.010 + 0.001 * static_cast<double>(k)) * 0.5 * (1.0 + std::cos(kPi * off));
    }
    return z;
  };
  const auto stations = survey(noisy(wave(360, dips), 0.0002, 2), 30.0, 0.0002);
  EXPECT_EQ(RingModel(ringData(stations, 30.0, {})).locals().size(), 8U);
}

/// Of errors alone a wave has three times their mean power in exp(-3), 5 % of all cases.
TEST(RingModel, AWaveStandsOutOfItsErrorsFromThreeTimesTheirPowerOn) {
  const auto shape = [](double a) {
    double z = 0.0;
    for (int n = 2; n <= 25; ++n) z += 0.004 * std::pow(2.0 / n, 2.0) * std::cos(n * a + n * n);
    return z;
  };
  const RingModel model(ringData(survey(wave(360, shape), 30.0, 0.001), 30.0, {}));
  const Eigen::VectorXd all = model.coefficients(), standing = model.standing();
  const Eigen::MatrixXd covariance = model.covariance();
  int just_below = 0, just_above = 0;
  for (int n = 2; n <= 25; ++n) {
    const Eigen::Index j = 2 * n - 1;
    const double over = all.segment<2>(j).squaredNorm() / (covariance(j, j) + covariance(j + 1, j + 1));
    EXPECT_EQ(standing.segment<2>(j).norm() > 0.0, over >= 3.0) << n;
    just_below += over > 1.5 && over < 3.0 ? 1 : 0;
    just_above += over > 3.0 && over < 6.0 ? 1 : 0;
  }
  EXPECT_GT(just_below, 0);
  EXPECT_GT(just_above, 0);
}

/// 64 stations that see waves of a foundation to 0.1 mm, and one of 10 mm that stands far above the others.
struct OneHighWave {
  static constexpr int kHigh = 15, kOrder = 31;
  static constexpr double kHeight = 0.010, kSigma = 1e-4, kVariance = kSigma * kSigma / 32.0;  ///< of a coefficient

  RingData data = ringData(survey(wave(64, &OneHighWave::z), 30.0, kSigma), 30.0, {});
  RingModel model{data};

  static double z(double a) {
    double sum = kHeight * std::cos(kHigh * a);
    for (int n = 2; n <= kOrder; ++n) sum += 0.004 * std::pow(2.0 / n, 2.0) * std::cos(n * a + n * n);
    return sum;
  }
  /// Variance before the survey of a coefficient, from that after it.
  double priorOf(int n) const {
    const double after = model.covariance()(2 * n - 1, 2 * n - 1);
    return after * kVariance / (kVariance - after);
  }
};

TEST(RingModel, TheVarianceOfAHighWaveIsLearntFromItInFiveStepsOfHalfTheWay) {
  const OneHighWave ring;
  const double seen = 0.5 * std::pow(ring.model.coefficients()[2 * OneHighWave::kHigh - 1], 2.0);
  EXPECT_NEAR(ring.priorOf(OneHighWave::kHigh) / seen, 1.0 - std::pow(0.5, 5.0), 0.01);
}

TEST(RingModel, TheVarianceOfTheOthersIsThatOfTheirPowerAndHalfAsMuchAgain) {
  const OneHighWave ring;
  const Eigen::MatrixXd rows = ring.model.rowsAt(ring.data.azimuths) / OneHighWave::kSigma;
  const Eigen::VectorXd z = (ring.data.z.array() - ring.data.z.mean()) / OneHighWave::kSigma;
  const Eigen::MatrixXd normal = rows.transpose() * rows;
  const Eigen::VectorXd rhs = rows.transpose() * z;
  const RingPriors priors = likeliestPriors({normal, rhs, z.squaredNorm(), 64, OneHighWave::kOrder, 1.0},
                                            {OneHighWave::kSigma, ring.data.usual_wave, {}})
                                .first;
  EXPECT_NEAR(ring.priorOf(20) / waveVariances(priors, OneHighWave::kOrder)[2 * 20], 1.5, 0.01);
}

TEST(RingModel, MeanAndTiltOfAnArcAreWithinTenTimesWhatIsLeftOfItsBestPlane) {
  // a fifth of the ring, level: waves of millimetres may hide in it, and stations known to a micrometre say nothing
  constexpr double kSigma = 1e-6;
  std::vector<double> z(60, kUnknown);
  std::fill_n(z.begin(), 12, 0.0);
  const RingData data = ringData(survey(z, 30.0, kSigma), 30.0, {});
  const Eigen::MatrixXd rows = harmonicRows(data.azimuths, 1);
  const Eigen::Matrix3d each = rows.transpose() * rows / (12.0 * kSigma * kSigma);  // of one station
  const Eigen::Matrix3d covariance = RingModel(data).covariance().topLeftCorner<3, 3>();
  EXPECT_NEAR(std::cbrt((covariance * each).determinant()), 10.0 * 10.0, 10.0);
}

}  // namespace tank_datum::ring_bounds_test
