#include "setups/merged_scans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/units.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

constexpr double kRadius = 10.0, kReach = 0.5;

/// Six setups, each seeing 100 degrees, one after the other; setup s is too high by errors[s].
Ring madeRing(const std::vector<double>& errors, bool shuffled = false) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Ring ring;
  ring.reach = kReach;
  ring.setups = {{0, 0}};
  for (std::size_t s = 0; s < errors.size(); ++s) {
    const double middle = kTwoPi * static_cast<double>(s) / static_cast<double>(errors.size());
    for (int column = 0; column < 2000; ++column) {
      const double azimuth = middle + toRadians(100.0) * (column / 2000.0 - 0.5);
      for (int row = 0; row < 12; ++row) {
        const bool shell = row % 3 == 0;
        const double radius = shell ? kRadius + 0.001 * normal(random) : kRadius + 0.03 + 0.3 * unit(random);
        const double z = shell ? 0.1 + 0.4 * unit(random) : 0.0005 * normal(random);
        ring.points.push_back({radius * std::cos(azimuth), radius * std::sin(azimuth), z + errors[s]});
      }
    }
  }
  if (shuffled) std::shuffle(ring.points.begin(), ring.points.end(), random);
  return ring;
}

/// The same with plants on the foundation of some arcs, a third of the points there.
Ring overgrown(Ring ring) {
  std::mt19937_64 random(4);
  std::exponential_distribution<double> height(1.0 / 0.05);
  std::bernoulli_distribution is_plant(0.3);
  for (Eigen::Vector3d& p : ring.points) {
    const double azimuth = std::atan2(p.y(), p.x());
    if (p.head<2>().norm() > kRadius + 0.02 && std::sin(6.0 * azimuth) > -0.5 && is_plant(random))
      p.z() += height(random);
  }
  return ring;
}

Tank madeTank() {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  return tank;
}

TEST(MergedScans, ScansThatDisagreeShowBySoMuch) {
  const std::vector<double> errors = {0.002, -0.002, 0.002, -0.002, 0.002, -0.002};
  // two scans 4 mm apart: the standard deviation of one is 4 mm / sqrt(2)
  EXPECT_NEAR(mergedDisagreement(madeRing(errors), madeTank()), 0.004 / std::sqrt(2.0), 0.0002);
}

TEST(MergedScans, ScansThatAgreeShowNothing) {
  EXPECT_LT(mergedDisagreement(madeRing({0, 0, 0, 0, 0, 0}), madeTank()), 0.0001);
  EXPECT_EQ(mergedDisagreement(madeRing({0.003}), madeTank()), 0.0);
}

TEST(MergedScans, PlantsAreNoDisagreement) {
  const std::vector<double> none(6, 0.0), errors = {0.002, -0.002, 0.002, -0.002, 0.002, -0.002};
  for (const bool shuffled : {true, false})
    EXPECT_LT(mergedDisagreement(overgrown(madeRing(none, shuffled)), madeTank()), 0.0001);
  EXPECT_NEAR(mergedDisagreement(overgrown(madeRing(errors)), madeTank()), 0.004 / std::sqrt(2.0), 0.0003);
}

/// The sigma of scans that disagree by sqrt(2) times so much.
double sigmaOf(double of_one, double given = 0.0) {
  return mergedSigma(Ring(), madeTank(), std::sqrt(2.0) * of_one, given);
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

/// A shell seen from outside from x on, over so many degrees, from so high above the foot on and so far off its circle.
double sigmaOfShell(double degrees, double from = 0.2, double off = 0.0, double given = 0.0,
                    Side side = Side::Outside) {
  Ring ring;
  ring.reach = kReach;
  for (double at = 0.25; at < degrees; at += 0.5) {
    const double radius = kRadius + off, z = from;
    ring.points.push_back({radius * std::cos(toRadians(at)), radius * std::sin(toRadians(at)), z});
  }
  Tank tank = madeTank();
  tank.side = side;
  return mergedSigma(ring, tank, 0.0, given);
}

TEST(MergedSigma, OfScansThatDoNotShowToDisagreeIsWhatIsUsualWhereOneSetupDoesNotSeeAllOfThem) {
  EXPECT_NEAR(sigmaOfShell(200.0), 0.0022, 1e-9);
  EXPECT_EQ(sigmaOfShell(185.0), 0.0);  // a shell and its centre are not known to a degree
  EXPECT_NEAR(sigmaOfShell(200.0, 0.2, 0.0, 0.0005), 0.0005, 1e-9);
  EXPECT_EQ(sigmaOfShell(360.0, 0.2, 0.0, 0.0, Side::Inside), 0.0);
}

TEST(MergedSigma, TheShellIsLookedForWhereItStands) {
  EXPECT_EQ(sigmaOfShell(360.0, 0.14), 0.0);
  EXPECT_GT(sigmaOfShell(360.0, 0.16), 0.0);
  for (const double side : {-1.0, 1.0}) {
    EXPECT_GT(sigmaOfShell(360.0, 0.2, side * 0.09), 0.0);
    EXPECT_EQ(sigmaOfShell(360.0, 0.2, side * 0.11), 0.0);
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

/// What two scans 4 mm apart that meet in so many arcs of 2.5 degrees disagree by.
double disagreementIn(int arcs) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any;
  Ring ring;
  ring.reach = 0.5;
  for (const double error : {0.002, -0.002}) {
    for (int i = 0; i < 400 * arcs; ++i) {
      const double azimuth = toRadians(2.5 * (i + 0.5) / 400.0);
      const bool shell = i % 4 == 0;
      const double d = shell ? 0.0 : 0.03 + 0.3 * any(random), z = shell ? 0.2 + 0.3 * any(random) : error;
      ring.points.push_back({(kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), z});
    }
  }
  return mergedDisagreement(ring, madeTank());
}

TEST(MergedScans, SixArcsTellADisagreementFiveDoNot) {
  EXPECT_EQ(disagreementIn(5), 0.0);
  EXPECT_GT(disagreementIn(8), 0.002);
}

/// What two scans of twenty arcs disagree by, whose points beside the shell lie at heights of their scan, arc and
/// distance, with noise.
double disagreementOfTwo(std::uint64_t seed, double sigma, const std::function<double(bool, int, double)>& height) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any;
  std::normal_distribution<double> noise(0.0, sigma);
  Ring ring;
  ring.reach = 0.5;
  for (const bool second : {false, true}) {
    for (int i = 0; i < 200 * 20; ++i) {
      const double azimuth = toRadians(2.5 * (i + 0.5) / 200.0);
      const bool shell = i % 4 == 0;
      const double d = shell ? 0.0 : 0.03 + 0.3 * any(random);
      const double z = shell ? 0.2 + 0.3 * any(random) : height(second, i / 200, d) + noise(random);
      ring.points.push_back({(kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), z});
    }
  }
  return mergedDisagreement(ring, madeTank());
}

/// Of two scans 2 mm apart, where the surface falls so steeply away from the shell.
double disagreementOnFall(double fall) {
  return disagreementOfTwo(6, 0.0005,
                           [fall](bool second, int, double d) { return (second ? -0.001 : 0.001) - fall * d; });
}

TEST(MergedScans, BanksLookAnotherFromEachPlace) {
  EXPECT_NEAR(disagreementOnFall(0.10), 0.002 / std::sqrt(2.0), 0.0002);
  EXPECT_EQ(disagreementOnFall(0.20), 0.0);
}

/// Of two scans of which the second is 1.5 mm higher in some arcs.
double withHigher(const std::vector<int>& arcs, std::uint64_t seed) {
  return disagreementOfTwo(seed, 0.004, [&arcs](bool second, int arc, double) {
    return second && std::find(arcs.begin(), arcs.end(), arc) != arcs.end() ? 0.0015 : 0.0;
  });
}

TEST(MergedScans, ArcsTellADisagreementWhereTheirNeighboursDoToo) {
  const auto told = [](const std::vector<int>& arcs) {  // of twenty such pairs of scans
    int count = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) count += withHigher(arcs, seed) > 0.0 ? 1 : 0;
    return count;
  };
  EXPECT_EQ(told({}), 0);
  EXPECT_LE(told({4}), 4) << "one beside it seems to as well, by chance";
  EXPECT_GE(told({4, 5, 6, 7}), 16);
}

}  // namespace
}  // namespace tank_datum
