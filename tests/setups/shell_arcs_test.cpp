#include "setups/shell_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "setups/setup_ring.h"

namespace tank_datum::shell_arcs_test {

/// A hundred points in each arc from one on to another, in so many of them.
ShellArcs seen(std::size_t from, std::size_t count) {
  ShellArcs arcs(SetupRing::kArcs, 0);
  for (std::size_t i = 0; i < count; ++i) arcs[(from + i) % arcs.size()] = 100;
  return arcs;
}

bool areNone(const std::vector<ShellArcs>& parts, Side side = Side::Outside, bool apart = false) {
  Tank tank;
  tank.side = side;
  return areNoSetups(parts, tank, apart);
}

/// So many parts, one beside the other all round, each reaching so many arcs into the next.
std::vector<ShellArcs> tiles(std::size_t count, std::size_t shared) {
  std::vector<ShellArcs> parts;
  const std::size_t width = SetupRing::kArcs / count;
  for (std::size_t i = 0; i < count; ++i) parts.push_back(seen(i * width, width + shared));
  return parts;
}

TEST(AreNoSetups, PartsThatShowMoreThanHalfOfAShell) {
  EXPECT_TRUE(areNone({seen(0, 144), seen(0, 144)}));
  EXPECT_TRUE(areNone({seen(0, 60), seen(40, 144)})) << "one of them";
  EXPECT_FALSE(areNone({seen(0, 60), seen(40, 60), seen(100, 60)}));
  EXPECT_FALSE(areNone({seen(0, 144), seen(0, 144)}, Side::Inside));
}

TEST(AreNoSetups, PartsThatMeetAtTheirBordersOnly) {
  EXPECT_TRUE(areNone(tiles(6, 1)));
  EXPECT_TRUE(areNone(tiles(6, 2)));
  EXPECT_FALSE(areNone(tiles(6, 3)));
  EXPECT_FALSE(areNone(tiles(6, 0))) << "each may be a setup that sees what no other does";
  EXPECT_FALSE(areNone(tiles(6, 1), Side::Outside, true)) << "they stood apart";
  EXPECT_TRUE(areNone({seen(0, 144), seen(0, 144)}, Side::Outside, true)) << "which no setup sees from anywhere";
}

/// Points by arc of a setup so many arcs wide: fewer and fewer towards the ends, where beams graze the shell.
ShellArcs setupAt(std::size_t middle, std::size_t width, double at_ends) {
  ShellArcs arcs(SetupRing::kArcs, 0);
  const double half = 0.5 * static_cast<double>(width);
  for (std::size_t i = 0; i < width; ++i) {
    const double off = std::abs(static_cast<double>(i) + 0.5 - half) / half;
    arcs[(middle + SetupRing::kArcs - width / 2 + i) % arcs.size()] =
        static_cast<std::size_t>(100.0 * (1.0 - (1.0 - at_ends) * off));
  }
  return arcs;
}

TEST(AreNoSetups, PartsThatThinOutWhereTheyMeetAreSetups) {
  EXPECT_FALSE(areNone({setupAt(20, 40, 0.05), setupAt(58, 40, 0.05)}));
  EXPECT_TRUE(areNone({setupAt(20, 40, 0.4), setupAt(58, 40, 0.4)}));
  ShellArcs left = seen(0, 20), right = seen(19, 20);
  left[19] = 55, right[19] = 35;
  EXPECT_TRUE(areNone({left, right})) << "a cloud cut in two";
}

TEST(AreNoSetups, PartsWithoutAPointOfTheShellAreNotCounted) {
  std::vector<ShellArcs> parts = tiles(6, 3);
  for (int i = 0; i < 6; ++i) parts.push_back(seen(0, 0));
  EXPECT_FALSE(areNone(parts));
}

TEST(AreNoSetups, StraysBesideAPartAreNotOfIt) {
  std::vector<ShellArcs> parts = tiles(6, 1);
  for (ShellArcs& arcs : parts) std::replace(arcs.begin(), arcs.end(), std::size_t{0}, std::size_t{4});
  EXPECT_TRUE(areNone(parts));
}

TEST(ShellArcs, OfSetupsAreThoseOfAllPointsSetupBySetup) {
  Tank tank;
  tank.circle = {{1.0, -2.0}, 10.0};
  tank.foot.coefficients = Eigen::Vector3d(0.0, 0.01, 0.0);
  Ring ring;
  ring.reach = 0.5;
  ring.setups.resize(2);
  for (int i = 0; i < 3000; ++i) {
    const double a = 0.0011 * i, off = 0.05 * (i % 9) - 0.2, z = 0.1 * (i % 5);
    ring.points.emplace_back(1.0 + (10.0 + off) * std::cos(a), -2.0 + (10.0 + off) * std::sin(a), z);
    ring.point_setups.push_back(i < 2000 ? 0 : 1);
  }
  const std::vector<ShellArcs> of_setups = shellArcsOfSetups(SetupRing(ring, tank, 1), tank, ring.reach, 2);
  ShellArcs all = shellArcs(ring, tank);
  EXPECT_GT(std::count_if(all.begin(), all.end(), [](std::size_t n) { return n > 0; }), 70);
  EXPECT_EQ(of_setups[1][0], 0U);
  EXPECT_GT(of_setups[1][SetupRing::kArcs / 2], 0U);
  for (std::size_t arc = 0; arc < all.size(); ++arc) EXPECT_EQ(of_setups[0][arc] + of_setups[1][arc], all[arc]) << arc;
}

}  // namespace tank_datum::shell_arcs_test
