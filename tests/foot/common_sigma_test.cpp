#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "foot/foot_check.h"

namespace tank_datum::common_sigma_test {

/// A level ring, measured with errors `truth` and standard errors `said`.
std::vector<FootFit> noisyRing(double truth, double said) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::vector<FootFit> fits(360);
  for (FootFit& fit : fits) {
    fit.z = truth * normal(random);
    fit.sigma = said;
  }
  return fits;
}

TEST(CommonSigma, IsNextToNothingForHonestSigmas) {
  EXPECT_LT(commonSigma(noisyRing(0.0002, 0.0002), 1), 0.0001);
  EXPECT_LT(commonSigma(noisyRing(0.0002, 0.0002), 3), 0.0001);
}

TEST(CommonSigma, IsWhatTheSigmasLeaveOut) {
  EXPECT_NEAR(commonSigma(noisyRing(0.0005, 0.0003), 1), 0.0004, 0.00006);
  EXPECT_NEAR(commonSigma(noisyRing(0.0005, 0.0003), 3), 0.0004, 0.00008);
}

TEST(CommonSigma, IsTheSameForSharpAndForBluntStations) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::vector<FootFit> fits(360);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    fits[i].sigma = i < 180 ? 0.0001 : 0.0004;
    fits[i].z = std::hypot(fits[i].sigma, 0.0003) * normal(random);
  }
  EXPECT_NEAR(commonSigma(fits, 1), 0.0003, 0.00006);
}

TEST(CommonSigma, IsNothingForSigmasTooLarge) { EXPECT_EQ(commonSigma(noisyRing(0.0001, 0.0004), 1), 0.0); }

TEST(CommonSigma, ComparesWindowsThatShareNoPoints) {
  auto fits = noisyRing(0.0, 0.0002);  // neighbours that share their points err alike
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  double error = 0;
  for (std::size_t i = 0; i < 360; ++i) {
    if (i % 5 == 0) error = 0.0006 * normal(random);
    fits[i].z += error;
  }
  EXPECT_NEAR(commonSigma(fits, 5), 0.00057, 0.0001);
  EXPECT_LT(commonSigma(fits, 1), 0.5 * commonSigma(fits, 5));
}

TEST(CommonSigma, IsNothingWhereThereIsTooLittleToTell) {
  auto fits = noisyRing(0.0008, 0.0002);
  for (std::size_t i = 12; i < 360; ++i) fits[i] = {};
  EXPECT_EQ(commonSigma(fits, 1), 0.0);
  EXPECT_EQ(commonSigma({}, 1), 0.0);
  EXPECT_EQ(commonSigma(noisyRing(0.0008, 0.0002), 90), 0.0);  // three windows round the tank
}

}  // namespace tank_datum::common_sigma_test
