#include "movement/movement_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"

namespace tank_datum {
namespace {

/// Differences of 1 mm sigma whose errors are means of white noise over `shared` stations.
std::vector<MatchedStation> differences(std::size_t count, std::size_t shared, unsigned seed, double errors = 0.001) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<double> white(count);
  for (double& w : white) w = normal(generator);
  std::vector<MatchedStation> stations(count);
  for (std::size_t i = 0; i < count; ++i) {
    MatchedStation& m = stations[i];
    m.direction = kTwoPi * static_cast<double>(i) / static_cast<double>(count);
    m.sigma = 0.001, m.window = 2.0 * kDegree;
    for (std::size_t k = 0; k < shared; ++k) m.dz += white[(i + k) % count];
    m.dz *= errors / std::sqrt(static_cast<double>(shared));
  }
  return stations;
}

double meanScale(std::size_t shared, double errors) {
  double sum = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed) sum += shownErrors(differences(360, shared, seed, errors)).shown / 20;
  return sum;
}

TEST(ShownErrors, AreThoseOfTheStations) {
  EXPECT_NEAR(meanScale(1, 0.001), 1.0, 0.07);
  EXPECT_NEAR(meanScale(1, 0.002), 2.0, 0.14);
  EXPECT_NEAR(meanScale(5, 0.001), 1.0, 0.10);
}

TEST(ShownErrors, KnowTheArcThatNeighboursShare) {
  for (const std::size_t shared : {5U, 20U}) {
    double arc = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed)
      arc += shownErrors(differences(360, shared, seed)).shared / kDegree / 20;
    EXPECT_GT(arc, 0.9 * static_cast<double>(shared));
    EXPECT_LT(arc, 1.6 * static_cast<double>(shared));
  }
  EXPECT_LT(shownErrors(differences(360, 1, 3)).shared, 4.0 * kDegree);
}

TEST(ShownErrors, AreNotMovedByASectorThatIs) {
  auto stations = differences(360, 1, 5);
  for (std::size_t i = 100; i < 160; ++i) stations[i].dz -= 0.015;
  EXPECT_NEAR(shownErrors(stations).shown, 1.0, 0.45);
}

TEST(ShownErrors, PatchesThreeTimesTheUsualScatterOffHaveMovedAndShareNoError) {
  // a third of the stations, in patches of eight: the usual scatter is then 1.7 mm
  for (unsigned seed = 1; seed <= 8; ++seed) {
    auto stations = differences(360, 1, seed);
    for (std::size_t i = 0; i < 360; ++i) {
      if (i % 24 < 8) stations[i].dz += i / 24 % 2 == 0 ? -0.0065 : 0.0065;
    }
    EXPECT_EQ(shownErrors(stations).shared, 0.0) << seed;
  }
}

TEST(ShownErrors, AreNotAWaveOfTheWholeRing) {
  for (const int n : {2, 3, 5}) {
    auto stations = differences(360, 1, 7);
    for (MatchedStation& m : stations) m.dz += 0.010 * std::cos(n * m.direction + 1.0);
    const MovementErrors errors = shownErrors(stations);
    EXPECT_NEAR(errors.shown, 1.0, 0.15) << n;
    EXPECT_LT(errors.shared, 4.0 * kDegree) << n;
  }
}

TEST(ShownErrors, AWaveIsNoErrorWhenItsPowerIsFiftyTimesThatOfShorterOnes) {
  const auto shown = [](double amplitude) {
    auto stations = differences(360, 1, 7, 0.0);
    for (MatchedStation& m : stations) {
      for (int n = 6; n <= 14; ++n) m.dz += 0.0005 * std::cos(n * m.direction + n * n);
      m.dz += 0.0005 * amplitude * std::cos(3.0 * m.direction);
    }
    return shownErrors(stations).shown;
  };
  const double without = shown(0.0);
  EXPECT_GT(shown(6.6), 1.5 * without);             // power 44: may be an error that neighbours share
  EXPECT_NEAR(shown(7.5), without, 0.1 * without);  // power 56
}

/// Values that scatter by `scatter` of their sigma as the biweight midvariance has it, without chance.
std::vector<MatchedStation> scattered(std::size_t count, double scatter) {
  auto stations = differences(count, 1, 1, 0.0);
  const double off = scatter * 76.0 / 80.0 * std::sqrt(1.0 - 3.0 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) stations[i].dz = (i % 2 == 0 ? off : -off) * stations[i].sigma;
  return stations;
}

TEST(ShownErrors, FewStationsMustShowAQuarterMoreThanGiven) {
  EXPECT_NEAR(shownErrors(scattered(14, 1.15)).shown, 1.15, 0.02);
  EXPECT_EQ(shownErrors(scattered(14, 1.15)).scale, 1.0);
  EXPECT_NEAR(shownErrors(scattered(14, 1.35)).scale, 1.35, 0.02);
  EXPECT_NEAR(shownErrors(scattered(18, 1.15)).scale, 1.15, 0.02);
}

TEST(ShownErrors, AScaleFromResidualsIsKnownByAsManyAsTheBiweightUses) {
  EXPECT_EQ(shownErrors(scattered(28, 1.15)).freedom, 0.0) << "the given sigmas stand";
  EXPECT_NEAR(shownErrors(scattered(28, 1.35)).freedom, 0.87 * 25.0, 1e-9);
  EXPECT_EQ(shownErrors(scattered(8, 2.0)).freedom, 0.87 * 5.0);
}

TEST(ShownErrors, AnArcThatIsLearntIsKnownByAsManyAsAreIndependent) {
  const MovementErrors none = shownErrors(differences(360, 1, 3));
  EXPECT_EQ(none.shared, 0.0);
  EXPECT_EQ(none.freedom_whole, 0.0);
  const MovementErrors learnt = shownErrors(differences(360, 20, 3));
  ASSERT_GT(learnt.shared, 10.0 * kDegree);
  EXPECT_NEAR(learnt.freedom_whole, 0.87 * (kTwoPi / learnt.shared - 3.0), 1e-9);
  const MovementErrors scaled = shownErrors(scattered(28, 1.35));
  EXPECT_EQ(scaled.freedom_whole, scaled.freedom) << "the scale is learnt, and no arc";
}

TEST(ShownErrors, ThirtyTwoStationsTellTheArcThatNeighboursShare) {
  int told = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    EXPECT_EQ(shownErrors(differences(30, 5, seed)).shared, 0.0);
    told += shownErrors(differences(36, 5, seed)).shared > 10.0 * kDegree ? 1 : 0;
  }
  EXPECT_GE(told, 10);
}

TEST(ShownErrors, AnArcIsGivenAQuarterMore) {
  auto stations = differences(360, 1, 1, 0.0);
  for (MatchedStation& m : stations) m.dz = 0.010 * std::sin(6.0 * m.direction);
  // correlations of stations k degrees apart are cos(6 k), above 0.35 up to k = 11: their sum is 8.42
  EXPECT_NEAR(shownErrors(stations).shared / kDegree, 1.25 * (1.0 + 2.0 * 8.42), 1.0);
}

TEST(ShownErrors, ACorrelationOfAQuarterIsNone) {
  int shared = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    auto stations = differences(360, 1, seed, 0.001 * std::sqrt(0.75));
    const auto wide = differences(360, 30, 100 + seed, 0.001 * std::sqrt(0.25));
    for (std::size_t i = 0; i < stations.size(); ++i) stations[i].dz += wide[i].dz;
    shared += shownErrors(stations).shared > 0.0 ? 1 : 0;
  }
  EXPECT_LE(shared, 5);
}

TEST(WidenErrors, TakesTheLargerAndTheDeclaredArc) {
  auto stations = differences(8, 1, 1);
  widenErrors(stations, {2.0, 2.0, 10.0 * kDegree, 0.0}, 0.0);
  EXPECT_NEAR(stations[0].sigma, 0.002, 1e-12);
  EXPECT_NEAR(stations[0].window, 10.0 * kDegree, 1e-12);
  widenErrors(stations, {1.0, 0.5, 0.0, 0.0}, 30.0 * kDegree);
  EXPECT_NEAR(stations[0].sigma, 0.002, 1e-12);
  EXPECT_NEAR(stations[0].window, 30.0 * kDegree, 1e-12);
}

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

}  // namespace
}  // namespace tank_datum
