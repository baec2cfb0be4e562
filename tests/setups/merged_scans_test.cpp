#include "setups/merged_scans.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "setups/setup_ring.h"
#include "stations/stations.h"

namespace tank_datum::merged_scans_test {

constexpr double kRadius = 10.0, kReach = 0.5;

Tank madeTank() {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return tank;
}

constexpr double kNoise = 0.001;  // of a tripod's scanner [m]

/// The sigma of scans that disagree by sqrt(2) times so much.
double sigmaOf(double of_one, double given = 0.0) {
  return mergedSigma(Ring(), madeTank(), std::sqrt(2.0) * of_one, given, kNoise);
}

TEST(MergedSigma, IsAsUncertainAsAVarianceFromFiveDifferences) {
  EXPECT_NEAR(sigmaOf(0.0050), 0.0050 * std::sqrt(1.0 + 2.0 / 5.0), 1e-9);
}

TEST(MergedSigma, OfScansThatAgreeWellIsDrawnTowardsTheUsualTwoMillimetres) {
  // a height of 2 mm and a tilt of 10 arc-seconds over 20 m; a quarter of it is worth one and a half parameters
  const double usual = std::hypot(0.002, 20.0 * toRadians(10.0 / 3600.0)), found = usual / 4.0;
  const double drawn = std::exp((5.0 * std::log(found) + 1.5 * std::log(usual)) / 6.5) * std::sqrt(1.0 + 2.0 / 6.5);
  EXPECT_NEAR(sigmaOf(found), drawn, 0.02 * drawn);
}

/// Adds so many points of a shell, evenly from one azimuth to another [deg].
void addArc(Ring& ring, double from, double to, int count, double radius = kRadius, double z = 0.2) {
  ring.reach = kReach;
  for (int i = 0; i < count; ++i) {
    const double at = toRadians(from + (to - from) * (i + 0.5) / count);
    ring.points.push_back({radius * std::cos(at), radius * std::sin(at), z});
  }
}

/// A shell seen from outside from x on, over so many degrees, from so high above the foot on and so far off its circle.
double sigmaOfShell(double degrees, double from = 0.2, double off = 0.0, double given = 0.0,
                    Side side = Side::Outside) {
  Ring ring;
  addArc(ring, 0.0, degrees, static_cast<int>(2.0 * degrees), kRadius + off, from);
  Tank tank = madeTank();
  tank.side = side;
  return mergedSigma(ring, tank, 0.0, given, kNoise);
}

const double kAssumed = 0.0022 * std::sqrt(5.0 / 3.0);  // usual, and uncertain itself [m]

TEST(MergedSigma, OfScansThatDoNotShowToDisagreeIsWhatIsUsualWhereOneSetupDoesNotSeeAllOfThem) {
  EXPECT_NEAR(sigmaOfShell(200.0), kAssumed, 1e-9);
  EXPECT_EQ(sigmaOfShell(185.0), 0.0);  // a shell and its centre are not known to a degree
  EXPECT_NEAR(sigmaOfShell(200.0, 0.2, 0.0, 0.0005), 0.0005, 1e-9);
  EXPECT_EQ(sigmaOfShell(360.0, 0.2, 0.0, 0.0, Side::Inside), 0.0);
}

TEST(MergedSigma, OfArcsThatNoneSeesTogetherIsWhatIsUsual) {
  // two arcs of 40 degrees with as many points as that, and how many of them in 2.5 degrees beyond
  const auto sigmaOfArcs = [](double apart, int beyond) {
    Ring ring;
    addArc(ring, 0.0, 40.0, 3200);
    addArc(ring, apart, apart + 40.0, 3200);
    addArc(ring, 250.0, 252.5, beyond);
    return mergedSigma(ring, madeTank(), 0.0, 0.0, kNoise);
  };
  EXPECT_EQ(sigmaOfArcs(100.0, 0), 0.0);
  EXPECT_NEAR(sigmaOfArcs(160.0, 0), kAssumed, 1e-9);
  EXPECT_EQ(sigmaOfArcs(100.0, 8), 0.0);  // strays
  EXPECT_GT(sigmaOfArcs(100.0, 14), 0.0);
}

TEST(MergedSigma, OfScansThatDoNotShowToDisagreeIsHalfOfWhatTheirNoiseIsWhereThatIsMore) {
  Ring ring;
  addArc(ring, 0.0, 360.0, 720);
  const auto sigmaOfNoise = [&](double noise, double given) {
    return mergedSigma(ring, madeTank(), 0.0, given, noise);
  };
  EXPECT_NEAR(sigmaOfNoise(0.005, 0.0), kAssumed, 1e-9);
  EXPECT_NEAR(sigmaOfNoise(0.012, 0.0), 0.006, 1e-9);
  EXPECT_NEAR(sigmaOfNoise(0.012, 0.002), 0.002, 1e-9) << "given";
}

TEST(MergedSigma, ArcsOfAFewPointsAreNotSeen) {
  const auto sigmaOfPoints = [](int of_an_arc) {
    Ring ring;
    addArc(ring, 0.0, 360.0, of_an_arc * static_cast<int>(SetupRing::kArcs));
    return mergedSigma(ring, madeTank(), 0.0, 0.0, kNoise);
  };
  EXPECT_EQ(sigmaOfPoints(4), 0.0);
  EXPECT_GT(sigmaOfPoints(6), 0.0);
}

TEST(MergedSigma, TheShellIsLookedForWhereItStands) {
  EXPECT_EQ(sigmaOfShell(360.0, 0.14), 0.0);
  EXPECT_GT(sigmaOfShell(360.0, 0.16), 0.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_GT(sigmaOfShell(360.0, 0.2, side * 0.19), 0.0);
    EXPECT_EQ(sigmaOfShell(360.0, 0.2, side * 0.21), 0.0);
  }
}

TEST(MergedScans, FactorsHaveTheVarianceEverywhereAndFadeWithDistance) {
  StationOptions options;
  std::vector<Station> stations = emptyStations(options);
  for (Station& s : stations) s.z = 0.0;
  stations[3].z = std::nan("");
  const Eigen::MatrixXd factors = mergedFactors(stations, 0.002);
  for (const int i : {0, 77, 359}) EXPECT_NEAR(factors.col(i).norm(), 0.002, 1e-12);
  EXPECT_EQ(factors.col(3).norm(), 0.0);
  const auto correlation = [&](int apart) { return factors.col(100).dot(factors.col(100 + apart)) / 4e-6; };
  EXPECT_NEAR(correlation(29), std::exp(-0.5), 0.05);  // half a radian on
  EXPECT_LT(std::abs(correlation(120)), 0.1);
}

TEST(MergedScans, TheShortestWaveOfTheFactorsHasAHundredthOfThePowerOfTheLongest) {
  std::vector<Station> stations = emptyStations({});
  for (Station& s : stations) s.z = 0.0;
  const Eigen::MatrixXd factors = mergedFactors(stations, 0.002);
  const Eigen::Index last = factors.rows() - 1;
  const double power = factors.row(last).squaredNorm() / factors.row(1).squaredNorm();
  EXPECT_GT(power, 0.005);
  EXPECT_LT(power, 0.03);
}

}  // namespace tank_datum::merged_scans_test
