#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "setups/merged_scans.h"

namespace tank_datum {
namespace {

constexpr double kRadius = 10.0;

/// A cloud of scans without labels, as it comes: visit after visit to arcs of 2.5 degrees.
class MergedCloud {
 public:
  MergedCloud() {
    ring_.reach = 0.5;
    ring_.setups = {{0, 0}};
  }

  /// Points of one scan on an arc, a quarter of them on the shell; the scan is too high by so much.
  void visit(int arc, double error, int count) {
    for (int i = 0; i < count; ++i) {
      const bool shell = i % 4 == 0;
      const double d = shell ? 0.0 : 0.03 + 0.3 * any_(random_), z = shell ? 0.2 + 0.3 * any_(random_) : error;
      add(arc, d, z + 0.0002 * normal_(random_));
    }
  }

  /// Points high on the shell of an arc that nothing is compared in.
  void lookElsewhere(int count) {
    for (int i = 0; i < count; ++i) add(100, 0.0, 0.4);
  }

  int size() const { return static_cast<int>(ring_.points.size()); }

  double disagreement() const {
    Tank tank;
    tank.circle = {{0.0, 0.0}, kRadius};
    tank.foot.coefficients = Eigen::Vector3d::Zero();
    return mergedDisagreement(ring_, tank);
  }

 private:
  void add(int arc, double d, double z) {
    const double azimuth = toRadians(2.5 * (arc + any_(random_)));
    ring_.points.push_back({(kRadius + d) * std::cos(azimuth), (kRadius + d) * std::sin(azimuth), z});
  }

  Ring ring_;
  std::mt19937_64 random_{3};
  std::uniform_real_distribution<double> any_;
  std::normal_distribution<double> normal_;
};

/// What two scans 4 mm apart disagree by when this share of all points lies between them in each of eight arcs.
double disagreementAfter(double share) {
  constexpr int kPoints = 20'000;
  MergedCloud cloud;
  for (int arc = 0; arc < 8; ++arc) {
    cloud.visit(arc, 0.002, 400);
    cloud.lookElsewhere(static_cast<int>(share * kPoints));
    cloud.visit(arc, -0.002, 400);
  }
  cloud.lookElsewhere(kPoints - cloud.size());
  return cloud.disagreement();
}

TEST(MergedVisits, PointsOfAnArcAreOfTwoScansWhenAHalfPercentOfAllLiesBetween) {
  EXPECT_EQ(disagreementAfter(0.004), 0.0);
  EXPECT_NEAR(disagreementAfter(0.006), 0.004 / std::sqrt(2.0), 0.0002);
}

/// Of 24 visits the seventh to the twelfth are 4 mm too high; the thirteenth to the last count as one.
TEST(MergedVisits, BeyondTheTwelfthTheyAreRowsOfOneScan) {
  MergedCloud cloud;
  for (int visit = 0; visit < 24; ++visit) {
    for (int arc = 0; arc < 8; ++arc) cloud.visit(arc, visit >= 6 && visit < 12 ? 0.004 : 0.0, 200);
  }
  EXPECT_NEAR(cloud.disagreement(), 0.004 * std::sqrt(6.0 * 7.0 / 13.0 / 12.0), 0.0001);
}

/// What two scans disagree by that are 4 mm apart in nine arcs, and in a tenth by so many times that variance.
double disagreementWith(double times) {
  MergedCloud cloud;
  for (const double error : {0.002, -0.002}) {
    for (int arc = 0; arc < 10; ++arc) cloud.visit(arc, error * (arc < 9 ? 1.0 : std::sqrt(times)), 400);
  }
  return cloud.disagreement();
}

TEST(MergedVisits, AnArcOfTwentyFiveTimesTheVarianceOfTheOthersShowsSomethingElse) {
  EXPECT_NEAR(disagreementWith(20.0), 0.004 / std::sqrt(2.0) * std::sqrt((9.0 + 20.0) / 10.0), 0.0002);
  EXPECT_NEAR(disagreementWith(30.0), 0.004 / std::sqrt(2.0), 0.0002);
}

}  // namespace
}  // namespace tank_datum
