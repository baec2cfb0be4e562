#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "io/up_axis.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::scan_turned_test {

const Points kPoints = {{4e6, 2.0, 3.0}, {4e6 + 1.0, 2.5, 7.0}, {4e6, 3.0, -1.0}};

Points absolute(const Scan& scan) {
  Points points;
  scan.forEachBlock([&](const Points& block) {
    for (const auto& p : block) points.push_back(p + scan.origin());
  });
  return points;
}

TEST(ScanTurned, EveryAxisCanBeUp) {
  const std::pair<const char*, Eigen::Vector3d> axes[] = {{"x", {1, 0, 0}},   {"y", {0, 1, 0}},   {"z", {0, 0, 1}},
                                                          {"-x", {-1, 0, 0}}, {"-y", {0, -1, 0}}, {"-z", {0, 0, -1}}};
  for (const auto& [name, axis] : axes) {
    const Eigen::Matrix3d turn = upRotation(name);
    EXPECT_EQ(turn * axis, Eigen::Vector3d::UnitZ()) << name;
    EXPECT_EQ(turn.determinant(), 1.0) << name;
    const Scan scan = Scan::fromPoints(kPoints).turned(turn);
    const Points turned = absolute(scan);
    for (std::size_t i = 0; i < kPoints.size(); ++i) EXPECT_EQ(turned[i], turn * kPoints[i]) << name;
  }
  EXPECT_THROW(upRotation("up"), Error);
}

TEST(ScanTurned, AboutAPointWhichStays) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.03, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  const Points turned = absolute(Scan::fromPoints(kPoints).turnedAbout(kPoints[1], turn));
  EXPECT_LT((turned[1] - kPoints[1]).norm(), 1e-9);
  EXPECT_LT((turned[2] - (turn * (kPoints[2] - kPoints[1]) + kPoints[1])).norm(), 1e-9);
}

TEST(ScanTurned, ChosenPointsAreTurnedBeforeTheyAreChosen) {
  const Scan scan = Scan::fromPoints(kPoints).turned(upRotation("y"));
  Points seen;
  const auto choose = [&](std::uint64_t, const Points& points, Points& chosen) {
    for (const auto& p : points) {
      if ((p + scan.origin()).z() > 2.2) chosen.push_back(p);
    }
  };
  scan.forEachChosen(choose, 1, [&](const Points& chosen) { seen.insert(seen.end(), chosen.begin(), chosen.end()); });
  EXPECT_EQ(seen.size(), 2U);
  EXPECT_EQ(scan.everyNth(1).size(), 3U);
}

TEST(ScanOrigin, IsAmongThePointsWhateverComesFirst) {
  Points points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(500'000.0 + 0.01 * i, 4'000'000.0, 30.0);
  const Eigen::Vector3d first = points.front();
  EXPECT_EQ(Scan::fromPoints(points).origin(), first);
  points.insert(points.begin(), Eigen::Vector3d::Zero());
  EXPECT_EQ(Scan::fromPoints(points).origin(), first);
  points.insert(points.begin(), {9e6, 9e6, 9e6});
  EXPECT_EQ(Scan::fromPoints(points).origin(), first);
  points.insert(points.begin(), 50'000, Eigen::Vector3d::Zero());  // more than a block of the sky
  EXPECT_EQ(Scan::fromPoints(points).origin(), first);
  EXPECT_EQ(Scan::fromPoints(Points(10, Eigen::Vector3d::Zero())).origin(), Eigen::Vector3d::Zero());
}

TEST(ScanTurned, AndRelativeToAnotherOrigin) {
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Scan scan = Scan::fromPoints({{10, 20, 30}, {11, 22, 33}});
  for (const Scan& of : {scan, scan.turned(turn)}) {
    const Scan moved = of.relativeTo({1, 2, 3});
    EXPECT_EQ(moved.origin(), Eigen::Vector3d(1, 2, 3));
    Points before, after;
    of.forEachBlock([&](const Points& block) { before = block; });
    moved.forEachBlock([&](const Points& block) { after = block; });
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(after[i] + moved.origin(), before[i] + of.origin());
  }
}

}  // namespace tank_datum::scan_turned_test
