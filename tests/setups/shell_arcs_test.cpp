#include "setups/shell_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "setups/setup_ring.h"

namespace tank_datum {
namespace {

using Arcs = std::vector<std::size_t>;

/// A hundred points in each arc from one on to another, in so many of them.
Arcs seen(std::size_t from, std::size_t count) {
  Arcs arcs(SetupRing::kArcs, 0);
  for (std::size_t i = 0; i < count; ++i) arcs[(from + i) % arcs.size()] = 100;
  return arcs;
}

bool areNone(const std::vector<Arcs>& parts, Side side = Side::Outside) {
  Tank tank;
  tank.side = side;
  return areNoSetups(parts, tank);
}

/// So many parts, one beside the other all round, each reaching so many arcs into the next.
std::vector<Arcs> tiles(std::size_t count, std::size_t shared) {
  std::vector<Arcs> parts;
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
}

TEST(AreNoSetups, PartsWithoutAPointOfTheShellAreNotCounted) {
  std::vector<Arcs> parts = tiles(6, 3);
  for (int i = 0; i < 6; ++i) parts.push_back(seen(0, 0));
  EXPECT_FALSE(areNone(parts));
}

TEST(AreNoSetups, StraysBesideAPartAreNotOfIt) {
  std::vector<Arcs> parts = tiles(6, 1);
  for (Arcs& arcs : parts) std::replace(arcs.begin(), arcs.end(), std::size_t{0}, std::size_t{4});
  EXPECT_TRUE(areNone(parts));
}

}  // namespace
}  // namespace tank_datum
