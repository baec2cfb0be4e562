#include "shape/ring_doubts.h"

#include <gtest/gtest.h>

#include "core/units.h"
#include "fit/harmonics.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::ring_doubts_test {

/// 360 stations; where something so high was refused above a datum of 1 m.
RingDoubts doubts(const std::vector<std::pair<std::size_t, double>>& refused) {
  std::vector<Station> stations(360);
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i].azimuth = toRadians(static_cast<double>(i));
  for (const auto& [at, height] : refused) stations[at].z_refused = 1.0 + height;
  return {stations, Eigen::VectorXd::Ones(360), Eigen::VectorXd::Zero(360)};
}

/// 360 stations known to 3 mm by those measured; the first of each pair interpolated with the standard error of the
/// second.
RingDoubts bridges(const std::vector<std::pair<std::size_t, double>>& interpolated, double refused = kUnknown) {
  std::vector<Station> stations(360);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].azimuth = toRadians(static_cast<double>(i));
    stations[i].flag = StationFlag::Measured;
    stations[i].sigma_z = 0.020;
  }
  for (const auto& [at, sigma] : interpolated) {
    stations[at].flag = StationFlag::Interpolated;
    stations[at].sigma_z = sigma;
    stations[at].z_refused = refused;
  }
  return {stations, Eigen::VectorXd::Ones(360), Eigen::VectorXd::Constant(360, 0.003)};
}

double at(const RingDoubts& doubts, double degrees, Eigen::Index gap = 0) {
  return doubts.at(Eigen::VectorXd::Constant(1, toRadians(degrees)))(0, gap);
}

TEST(RingDoubts, AreStraightBetweenStationsAndNothingBeyondTheGap) {
  const RingDoubts two = doubts({{0, 0.030}, {359, 0.010}, {100, -0.020}});
  ASSERT_EQ(two.at(Eigen::VectorXd::Zero(1)).cols(), 2);
  const Eigen::Index over = at(two, 0.0) > 0.0 ? 0 : 1;
  EXPECT_NEAR(at(two, 0.0, over), 0.030, 1e-12);
  EXPECT_NEAR(at(two, 359.0, over), 0.010, 1e-12);
  EXPECT_NEAR(at(two, 359.5, over), 0.020, 1e-9);
  EXPECT_NEAR(at(two, 0.25, over), 0.0225, 1e-9);
  EXPECT_NEAR(at(two, 358.0, over), 0.0, 1e-9);
  EXPECT_NEAR(at(two, 1.0, over), 0.0, 1e-9);
  EXPECT_EQ(at(two, 100.0, over), 0.0);
  EXPECT_NEAR(at(two, 100.0, 1 - over), -0.020, 1e-12);
}

/// Its waves are those of the ring that it adds.
TEST(RingDoubts, WavesAreThoseOfTheirValues) {
  std::vector<std::pair<std::size_t, double>> wide;
  for (std::size_t i = 0; i < 360; ++i) {
    if (i > 180) wide.push_back({i, -0.02 * std::sin(toRadians(static_cast<double>(i)))});
  }
  const Eigen::VectorXd waves = doubts(wide).waves(4);
  ASSERT_EQ(waves.size(), 9);
  EXPECT_NEAR(waves[0], 0.02 / kPi, 1e-5);  // half a sine
  EXPECT_NEAR(waves[2], -0.01, 1e-5);
  EXPECT_NEAR(waves[3], -0.02 * 2.0 / (3.0 * kPi), 1e-5);
}

TEST(RingDoubts, EachGapIsTheOneOrTheOtherAsLikelyAsNot) {
  const Eigen::MatrixXd drawn = doubts({{10, 0.01}, {200, 0.01}}).drawn(400, 7);
  ASSERT_EQ(drawn.rows(), 2);
  EXPECT_NEAR(drawn.row(0).mean(), 0.5, 0.1);
  EXPECT_NEAR(drawn.row(1).mean(), 0.5, 0.1);
  EXPECT_NEAR((drawn.row(0) - drawn.row(1)).cwiseAbs().mean(), 0.5, 0.1);
  EXPECT_EQ(drawn.cwiseProduct((drawn.array() - 1.0).matrix()).cwiseAbs().maxCoeff(), 0.0);
}

/// A bridge is off by what its errors exceed those that the measured stations leave, all of it alike.
TEST(RingDoubts, ABridgeIsOffAlongItsWholeGapByWhatItsErrorExceeds) {
  const RingDoubts one = bridges({{100, 0.005}, {101, 0.005}, {102, 0.003}});
  ASSERT_EQ(one.at(Eigen::VectorXd::Zero(1)).cols(), 1);
  EXPECT_NEAR(at(one, 100.0), 0.004, 1e-12);
  EXPECT_NEAR(at(one, 101.0), 0.004, 1e-12);
  EXPECT_NEAR(at(one, 102.0), 0.0, 1e-12);
  EXPECT_NEAR(at(one, 99.0), 0.0, 1e-12);
  const Eigen::MatrixXd drawn = one.drawn(4000, 7);
  EXPECT_NEAR(drawn.mean(), 0.0, 0.05);
  EXPECT_NEAR(drawn.squaredNorm() / 4000.0, 1.0, 0.1);
}

TEST(RingDoubts, ABridgeThatHoldsWhatWasRefusedIsDoubtedOnce) {
  const RingDoubts one = bridges({{100, 0.005}}, 1.010);
  ASSERT_EQ(one.at(Eigen::VectorXd::Zero(1)).cols(), 1);
  EXPECT_NEAR(at(one, 100.0), 0.010, 1e-12);
}

TEST(RingDoubts, NoneOfABridgeAsSureAsTheMeasuredStationsMakeIt) {
  EXPECT_TRUE(bridges({{100, 0.003}, {200, 0.001}, {201, kUnknown}}).empty());
}

TEST(RingDoubts, NoneWhereNothingWasRefusedOrNothingWasMeasured) {
  EXPECT_TRUE(doubts({}).empty());
  std::vector<std::pair<std::size_t, double>> all;
  for (std::size_t i = 0; i < 360; ++i) all.push_back({i, 0.01});
  EXPECT_TRUE(doubts(all).empty());
}

}  // namespace tank_datum::ring_doubts_test
