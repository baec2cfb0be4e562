#include "setups/before_shell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/units.h"

namespace tank_datum::before_shell_test {

constexpr double kRadius = 30.0, kReach = 0.5;
constexpr double kArc = kTwoPi / static_cast<double>(SetupRing::kArcs);

/// In which of twenty arcs of a shell, which one setup sees, another sees something before it, where it sees so many
/// arcs from the sixth on so far out of the shell, and the first one so far too.
std::vector<bool> heldBefore(double out, int arcs, Side side = Side::Outside, double first_out = 0.0) {
  Ring ring;
  ring.reach = kReach;
  ring.setups = {{0, 0}, {1, 0}};
  const auto add = [&ring](int setup, double azimuth, double radius) {
    ring.points.push_back({radius * std::cos(azimuth), radius * std::sin(azimuth), 0.3});
    ring.point_setups.push_back(static_cast<std::uint16_t>(setup));
  };
  for (int arc = 0; arc < 20; ++arc) {
    for (int i = 0; i < 30; ++i) {
      const double azimuth = kArc * (arc + (i + 0.5) / 30.0);
      const bool stands_out = arc >= 6 && arc < 6 + arcs;
      add(0, azimuth, kRadius + (stands_out ? first_out : 0.0));
      add(1, azimuth, kRadius + (stands_out ? out : 0.0));
    }
  }
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.side = side;
  const BeforeShell before(
      SetupRing(ring, tank, 1), tank, kReach, [](const auto& e) { return e.radius; }, 1);
  std::vector<bool> held;
  for (int arc = 0; arc < 20; ++arc) {
    EXPECT_FALSE(before.holds({kArc * (arc + 0.5), kRadius, 0.3, 0}));
    held.push_back(before.holds({kArc * (arc + 0.5), kRadius, 0.3, 1}));
  }
  return held;
}

int countOf(const std::vector<bool>& held) { return static_cast<int>(std::count(held.begin(), held.end(), true)); }

TEST(BeforeShell, IsFartherOutThanAShellBends) {
  EXPECT_EQ(countOf(heldBefore(0.016, 1)), 0);  // 5 mm and a hundredth of 1.31 m
  const std::vector<bool> held = heldBefore(0.020, 1);
  EXPECT_EQ(countOf(held), 1);
  EXPECT_TRUE(held[6]);
}

TEST(BeforeShell, IsFourArcsFromTheShellAtMost) {
  EXPECT_EQ(countOf(heldBefore(0.2, 7)), 7);
  const std::vector<bool> held = heldBefore(0.2, 10);
  EXPECT_EQ(countOf(held), 8);
  EXPECT_FALSE(held[10] || held[11]);
}

TEST(BeforeShell, IsNoLobeWhichStandsOutForAll) {
  EXPECT_EQ(countOf(heldBefore(0.06, 1, Side::Outside, 0.045)), 0);
  EXPECT_EQ(countOf(heldBefore(0.06, 1, Side::Outside, 0.035)), 1);
}

TEST(BeforeShell, StandsInsideOfAShellThatIsSeenFromWithin) {
  EXPECT_EQ(countOf(heldBefore(-0.03, 1)), 2);  // what is beside it, from outside
  const std::vector<bool> held = heldBefore(-0.03, 1, Side::Inside);
  EXPECT_EQ(countOf(held), 1);
  EXPECT_TRUE(held[6]);
}

}  // namespace tank_datum::before_shell_test
