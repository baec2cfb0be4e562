#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "movement/movement_errors.h"
#include "support/made_differences.h"

namespace tank_datum::common_motion_test {

using made_differences::differences;

TEST(CommonMotion, OfAUniformDropIsSevenSigma) {
  auto stations = differences(24, 1, 1, 0.0);
  for (MatchedStation& m : stations) m.dz = -0.002, m.sigma = 0.001 * std::sqrt(2.0);
  const CommonMotion motion = commonMotion(stations, 0.0, 0.0);
  EXPECT_NEAR(motion.mean, -0.002, 1e-12);
  EXPECT_NEAR(motion.sigma_mean, 0.001 * std::sqrt(2.0 / 24.0), 1e-9);
  EXPECT_NEAR(motion.rim.norm(), 0.0, 1e-12);
  EXPECT_NEAR(commonMotion(stations, 0.003, 0.0).sigma_mean, std::hypot(0.003, 0.001 * std::sqrt(2.0 / 24.0)), 1e-9);
}

TEST(CommonMotion, OfATiltIsItsRim) {
  auto stations = differences(36, 1, 1, 0.0);
  for (MatchedStation& m : stations) m.dz = 0.003 * std::cos(m.direction) + 0.004 * std::sin(m.direction);
  const CommonMotion motion = commonMotion(stations, 0.0, 0.0);
  EXPECT_NEAR(motion.rim.x(), 0.003, 1e-12);
  EXPECT_NEAR(motion.rim.y(), 0.004, 1e-12);
  EXPECT_NEAR(motion.covariance(0, 0), 1e-6 * 2.0 / 36.0, 1e-12);
  for (MatchedStation& m : stations) m.window = 40.0 * kDegree;  // four neighbours share nearly all
  EXPECT_GT(commonMotion(stations, 0.0, 0.0).covariance(0, 0), 2.5e-6 * 2.0 / 36.0);
}

/// Stations of own errors of 0.2 mm that share a height of 1 mm.
std::vector<MatchedStation> hanging(std::size_t count) {
  auto stations = differences(count, 1, 1, 0.0);
  for (MatchedStation& m : stations) {
    m.shared = Eigen::VectorXd::Constant(1, 0.001);
    m.sigma = std::hypot(0.0002, 0.001);
  }
  return stations;
}

TEST(CommonMotion, OfStationsThatShareAHeightIsKnownNoBetterThanThat) {
  const CommonMotion motion = commonMotion(hanging(100), 0.0, 0.0);
  EXPECT_NEAR(motion.sigma_mean, std::hypot(0.001, 0.0002 / 10.0), 1e-6);
  EXPECT_LT(std::sqrt(motion.covariance(0, 0)), 0.00005);
}

TEST(CommonPart, TakesASharedHeightFromTheErrorsWithTheMean) {
  auto stations = hanging(100);
  CommonPart(stations, Removal::Mean, true).removeFromErrors(stations);
  EXPECT_NEAR(stations[7].sigma, 0.0002, 1e-9);
  EXPECT_NEAR(stations[7].shared.norm(), 0.0, 1e-12);
}

TEST(WidenErrors, OfStationsThatShareSomeAreTheirOwn) {
  auto stations = hanging(100);
  widenErrors(stations, {2.0, 2.0, 0.0, 0.0}, 0.0);
  EXPECT_NEAR(stations[7].sigma, std::hypot(0.0004, 0.001), 1e-12);
}

TEST(TiltPValue, IsThatOfFOrOfChiSquare) {
  CommonMotion motion;
  motion.rim << 3.0, 0.0;
  motion.covariance.setIdentity();
  EXPECT_NEAR(tiltPValue(motion, 0.0), std::exp(-4.5), 1e-12);
  // F with 2 and 10 degrees of freedom exceeds 4.103 in 5 %
  motion.rim << 0.0, std::sqrt(2.0 * 4.103);
  EXPECT_NEAR(tiltPValue(motion, 10.0), 0.05, 1e-4);
}

TEST(CommonPart, ASectorThatMovedDoesNotMoveTheOthers) {
  for (const Removal removal : {Removal::Mean, Removal::Tilt}) {
    auto stations = differences(360, 1, 2, 0.0003);
    for (std::size_t i = 100; i < 160; ++i) stations[i].dz -= 0.005;
    for (MatchedStation& m : stations) m.dz += 0.010, m.sigma = 0.0003;
    CommonPart(stations, removal, true).removeFrom(stations);
    double others = 0.0, sector = 0.0;
    for (std::size_t i = 0; i < 360; ++i) (i >= 100 && i < 160 ? sector : others) += stations[i].dz;
    EXPECT_NEAR(others / 300.0, 0.0, 6e-5);
    EXPECT_NEAR(sector / 60.0, -0.005, 2e-4);
  }
}

}  // namespace tank_datum::common_motion_test
