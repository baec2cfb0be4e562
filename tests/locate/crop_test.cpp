#include "locate/crop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/made_clouds.h"
#include "support/refused.h"

namespace tank_datum::crop_test {

using made_clouds::kTurn;
using made_clouds::uniform;

/// A tank of 10 m about (3, -4), its foot a tilted plane.
Tank tank10(double slope_x = 0.0, double slope_y = 0.0) {
  Tank tank;
  tank.circle = {{3.0, -4.0}, 10.0};
  tank.foot.coefficients = Eigen::Vector3d(2.0, 10.0 * slope_x, 10.0 * slope_y);
  return tank;
}

Eigen::Vector3d place(const Tank& tank, double azimuth, double off, double up) {
  const double r = tank.circle.radius + off;
  return {tank.circle.center.x() + r * std::cos(azimuth), tank.circle.center.y() + r * std::sin(azimuth),
          tank.foot(azimuth) + up};
}

/// Of every scan here: its origin is the frame's zero to the last bit, yet it is no row of a beam without return.
const Eigen::Vector3d kFirst(0.0, 0.0, 1e-300);

/// How many of one point are kept; the scan's frame is the tank's.
std::size_t kept(const Tank& tank, const Eigen::Vector3d& point, const CropOptions& options = {}) {
  return cropRing(Scan::fromPoints({kFirst, point}), tank, options).points.size();
}

TEST(CropRing, KeepsWhatIsWithinTheReachOfTheFoot) {
  const Tank tank = tank10();
  EXPECT_EQ(kept(tank, place(tank, 1.0, 0.0, 0.0)), 1U);
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(kept(tank, place(tank, 1.0, sign * 0.49, 0.0)), 1U);
    EXPECT_EQ(kept(tank, place(tank, 1.0, sign * 0.51, 0.0)), 0U);
    EXPECT_EQ(kept(tank, place(tank, 1.0, 0.0, sign * 0.49)), 1U);
    EXPECT_EQ(kept(tank, place(tank, 1.0, 0.0, sign * 0.51)), 0U);
  }
}

TEST(CropRing, ReachIsAnOption) {
  const Tank tank = tank10();
  CropOptions options;
  options.reach = 0.8;
  EXPECT_EQ(kept(tank, place(tank, 4.0, 0.7, -0.7), options), 1U);
  EXPECT_EQ(kept(tank, place(tank, 4.0, 0.7, -0.7)), 0U);
  EXPECT_EQ(cropRing(Scan::fromPoints({}), tank, options).reach, 0.8);
}

TEST(CropRing, OnSmallObjectsTheReachIsHalfTheRadius) {
  Tank can = tank10();
  can.circle.radius = 0.04;
  can.foot.coefficients = Eigen::Vector3d(2.0, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(cropRing(Scan::fromPoints({}), can, {}).reach, 0.02);
  EXPECT_EQ(kept(can, place(can, 1.0, 0.019, 0.0)), 1U);
  EXPECT_EQ(kept(can, place(can, 1.0, 0.021, 0.0)), 0U);
  EXPECT_EQ(kept(can, place(can, 1.0, 0.0, 0.021)), 0U);
}

TEST(CropRing, IsEnlargedByTheAccuracyOfTheCoarseFigures) {
  Tank tank = tank10();
  EXPECT_EQ(kept(tank, place(tank, 2.0, 0.55, 0.0)), 0U);
  tank.resolution = 0.04;
  EXPECT_EQ(kept(tank, place(tank, 2.0, 0.55, 0.0)), 1U);
  EXPECT_EQ(kept(tank, place(tank, 2.0, 0.0, 0.55)), 1U);
  EXPECT_EQ(kept(tank, place(tank, 2.0, 0.60, 0.0)), 0U);
  EXPECT_EQ(cropRing(Scan::fromPoints({}), tank, {}).reach, 0.5);
}

TEST(CropRing, FollowsATiltedFoot) {
  const Tank tank = tank10(0.1, -0.05);  // a metre up on one side
  for (const double azimuth : {0.0, 1.0, 2.5, 4.0, 5.5}) {
    EXPECT_EQ(kept(tank, place(tank, azimuth, 0.0, 0.49)), 1U) << azimuth;
    EXPECT_EQ(kept(tank, place(tank, azimuth, 0.0, -0.49)), 1U) << azimuth;
    EXPECT_EQ(kept(tank, place(tank, azimuth, 0.0, 0.51)), 0U) << azimuth;
    EXPECT_EQ(kept(tank, place(tank, azimuth, 0.0, -0.51)), 0U) << azimuth;
  }
  EXPECT_EQ(kept(tank10(), place(tank, 0.0, 0.0, 0.0)), 0U);
}

TEST(CropRing, IsRelativeToTheOriginOfTheScan) {
  const Tank tank = tank10();  // in the frame that begins at the first point
  const Eigen::Vector3d origin(512034.25, 4012877.5, 812.0), p = place(tank, 1.0, 0.1, 0.1);
  const Ring ring = cropRing(Scan::fromPoints({origin, origin + p}), tank, {});
  ASSERT_EQ(ring.points.size(), 1U);
  EXPECT_NEAR((ring.points[0] - p).norm(), 0.0, 1e-8);
}

TEST(CropRing, CountsWhatThePassMet) {
  const Tank tank = tank10();
  const Ring ring =
      cropRing(Scan::fromPoints({kFirst, {NAN, 0, 0}, place(tank, 1.0, 0.0, 0.0), {0, 0, INFINITY}}), tank, {});
  EXPECT_EQ(ring.counts.points, 4U);
  EXPECT_EQ(ring.counts.invalid, 2U);
  EXPECT_EQ(ring.points.size(), 1U);
}

/// A shell and a pad about the tank's foot, the first half of the turn ten times as dense.
Points foot(const Tank& tank, int count) {
  std::mt19937_64 random(3);
  Points points(1, kFirst);
  for (int i = 0; i < count; ++i) {
    const double a = (i % 11 == 0 ? 0.5 : 0.0) * kTurn + 0.5 * kTurn * uniform(random), along = 0.5 * uniform(random);
    points.push_back(i % 2 == 0 ? place(tank, a, 0.0, along) : place(tank, a, along, 0.0));
  }
  return points;
}

TEST(CropRing, FewerPointsThanTheBoundAreNotThinned) {
  const Tank tank = tank10();
  const Ring ring = cropRing(Scan::fromPoints(foot(tank, 20'000)), tank, {});
  EXPECT_EQ(ring.points.size(), 20'000U);
  EXPECT_EQ(ring.search, ring.points);
}

TEST(CropRing, TheSearchIsThinnedEvenlyAndTheFitKeepsAll) {
  const Tank tank = tank10();
  CropOptions options;
  options.search_points = 5'000;
  const Ring ring = cropRing(Scan::fromPoints(foot(tank, 60'000)), tank, options);
  EXPECT_EQ(ring.points.size(), 60'000U);
  EXPECT_LE(ring.search.size(), 5'000U);
  EXPECT_GT(ring.search.size(), 1'000U);  // voxels double, so no less than a quarter of the bound goes unused
  const auto first_half = [&](const Points& points) {
    return static_cast<double>(
               std::count_if(points.begin(), points.end(), [](const auto& p) { return p.y() > -4.0; })) /
           static_cast<double>(points.size());
  };
  EXPECT_NEAR(first_half(ring.points), 10.0 / 11.0, 0.01);
  EXPECT_NEAR(first_half(ring.search), 0.5, 0.1);
}

TEST(CropOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(CropOptions())), "");
  CropOptions options;
  for (const double reach : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)}) {
    options.reach = reach;
    EXPECT_EQ(said(firstError(options)).rfind("crop.reach, ", 0), 0U) << reach;
  }
  options = {};
  options.search_points = 999;
  EXPECT_EQ(said(firstError(options)), "search_points, 999, expected >= 1000");
  options = {};
  options.fit_points = 999;
  EXPECT_EQ(said(firstError(options)), "fit_points, 999, expected >= 1000");
}

TEST(CropRing, OfMorePointsThanTheFitsTakeAnEvenShareIsKeptWhateverTheirOrder) {
  const Tank tank = tank10();
  Points points = foot(tank, 60'000);
  CropOptions options;
  options.fit_points = 20'000;
  const Ring ring = cropRing(Scan::fromPoints(points), tank, options);
  EXPECT_LE(ring.points.size(), 20'000U);
  EXPECT_GT(ring.points.size(), 9'500U);  // halved until they fit
  EXPECT_EQ(ring.counts.points, points.size());
  const auto dense = std::count_if(ring.points.begin(), ring.points.end(), [](const auto& p) { return p.y() > -4.0; });
  EXPECT_NEAR(static_cast<double>(dense) / static_cast<double>(ring.points.size()), 10.0 / 11.0, 0.01);

  std::reverse(points.begin() + 1, points.end());  // the first is the origin
  Points other = cropRing(Scan::fromPoints(points), tank, options).points;
  std::reverse(other.begin(), other.end());
  EXPECT_EQ(other, ring.points);
  options.fit_points = 60'000;
  EXPECT_EQ(cropRing(Scan::fromPoints(points), tank, options).points.size(), 60'000U);
}

TEST(RowStride, GrowsWithWhatTheRingHoldsBeyondWhatTheFitsTake) {
  Tank tank = tank10();
  const auto any = [](std::uint64_t) { return Eigen::Vector3d(1, 2, 3); };
  const Scan scan = Scan::fromRows(300'000'000, any);
  CropOptions options;
  EXPECT_EQ(rowStride(scan, tank, options), 1U);  // nothing is known of the share
  tank.near_foot = 0.03;
  EXPECT_EQ(rowStride(scan, tank, options), 1U);  // of 9 million points
  tank.near_foot = 0.11;
  EXPECT_EQ(rowStride(scan, tank, options), 9U);  // 8.25, and odd
  options.reach = 0.25;
  EXPECT_EQ(rowStride(scan, tank, options), 5U);
  tank.resolution = 0.125;  // the ring is wider by it on both sides
  EXPECT_EQ(rowStride(scan, tank, options), 9U);
  tank.circle.radius = 0.1;  // of a small thing the ring is half its radius wide
  tank.resolution = 0.0;
  EXPECT_EQ(rowStride(scan, tank, options), 1U);
}

TEST(RowStride, LeavesTheShellEnoughRows) {
  Tank tank = tank10();
  tank.near_foot = 1.0;
  const auto any = [](std::uint64_t) { return Eigen::Vector3d(1, 2, 3); };
  EXPECT_EQ(rowStride(Scan::fromRows(30'000'000, any), tank, {}), 1U);
  EXPECT_EQ(rowStride(Scan::fromRows(90'000'000, any), tank, {}), 3U);
  EXPECT_EQ(rowStride(Scan::fromRows(1'000'000'000, any), tank, {}), 33U);
}

TEST(CropRing, GathersAnotherPartOfTheScanInTheSamePass) {
  const Tank tank = tank10();
  const Points points = {kFirst, place(tank, 1.0, 0, 0), place(tank, 1.0, 0, 9), place(tank, 2.0, 0, 0), {1, 1, 1}};
  Points given;
  const auto high = [&given](std::uint64_t /*n*/, const Points& block) {
    std::copy_if(block.begin(), block.end(), std::back_inserter(given), [](const auto& p) { return p.z() > 5.0; });
  };
  const Ring ring = cropRing(Scan::fromPoints(points), tank, {}, high);
  EXPECT_EQ(ring.points, (Points{points[1], points[3]}));
  EXPECT_EQ(given, (Points{points[2]}));
}

TEST(RowStride, IsWorthItFromTwoAndAHalfTimesWhatTheFitsTake) {
  Tank tank = tank10();
  const Scan scan = Scan::fromRows(300'000'000, [](std::uint64_t) { return Eigen::Vector3d(1, 2, 3); });
  tank.near_foot = 2.4 * 4e6 / 3e8;
  EXPECT_EQ(rowStride(scan, tank, {}), 1U);
  tank.near_foot = 2.6 * 4e6 / 3e8;
  EXPECT_EQ(rowStride(scan, tank, {}), 3U);
}

}  // namespace tank_datum::crop_test
