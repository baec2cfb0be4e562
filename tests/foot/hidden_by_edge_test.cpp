#include <gtest/gtest.h>

#include <cmath>

#include "foot/grazed_arcs.h"
#include "support/made_feet.h"

namespace tank_datum::hidden_by_edge_test {

using namespace made_feet;

constexpr double kNear = 0.013;

/// What beams leave between a shell and an edge that hides its foot, seen from inside.
struct Left {
  double share = 0.3;    ///< of its slope, that rays show it by; a surface's if they fall by so much more
  double slope = 0.15;   ///< rising outwards [m/m]
  double level = 0.0;    ///< share of its points that lie on a level surface instead
  double nearest = 0.0;  ///< length beside the shell where it is ten times as dense [m]
  double edge = 10.0;    ///< how many times as dense what stands farther out is
  bool inside = true;
};

Left with(double Left::*figure, double value, Left left = {}) {
  left.*figure = value;
  return left;
}

/// Whether an arc of it is grazed.
bool isGrazed(const Left& left) {
  constexpr double kEnd = 0.263, kDenser = 9.0, kEdge = 0.40, kWide = 0.04;
  constexpr double kDense = 9000.0;  // points of a station and metre of the shell
  constexpr int kArc = 10;
  MadeFoot made;
  const auto height = [&](double d) { return left.slope * d; };
  const double a_metre = kDense * left.share * left.slope;
  for (int station = -kArc; station <= kArc; ++station) {
    const int i = (station + 360) % 360;
    const auto put = [&](double share, double to, const auto& at) {
      made.addStation(i, static_cast<int>(std::lround(share * a_metre * (to - kNear))), kNear, to, at);
    };
    put(1.0 - left.level, kEnd, height);
    put(left.level, kEnd, [](double) { return 0.0; });
    put(kDenser, kNear + left.nearest, height);
    made.addStation(i, static_cast<int>(std::lround(left.edge * a_metre * kWide)), kEdge, kEdge + kWide, height);
    made.addShell(i, static_cast<int>(kDense * 0.4 * kReach));
  }
  FootPass pass = levelPass(0.5 * made.step(), kEnd);
  pass.priors.slope.assign(360, left.slope);
  pass.sections.whole.noise = 0.02;
  Foot& foot = made.foot();
  foot.inside = left.inside;
  return findGrazedArcs(foot, pass, pass.fits)[0];
}

TEST(FindGrazedArcs, FindsFewPointsInLineThatRiseToAnEdge) {
  EXPECT_TRUE(isGrazed(Left{}));
  EXPECT_TRUE(isGrazed(Left{0.45}));
  EXPECT_FALSE(isGrazed(Left{0.55}));  // a surface may show so many
}

TEST(FindGrazedArcs, LeavesFewPointsThatGoOnAsTheyDoOnAWetFloor) {
  EXPECT_TRUE(isGrazed(with(&Left::edge, 5.0)));
  EXPECT_FALSE(isGrazed(with(&Left::edge, 3.5)));
}

TEST(FindGrazedArcs, LeavesFewPointsInLineOutside) {
  Left left;
  left.inside = false;
  EXPECT_FALSE(isGrazed(left));
}

TEST(FindGrazedArcs, LeavesFewPointsThatRiseAsALipDoes) {
  EXPECT_TRUE(isGrazed(Left{0.3, 0.06}));
  EXPECT_FALSE(isGrazed(Left{0.3, 0.045}));
}

TEST(FindGrazedArcs, LeavesFewPointsThatAreNotInLine) {
  EXPECT_TRUE(isGrazed(with(&Left::level, 0.03)));
  EXPECT_FALSE(isGrazed(with(&Left::level, 0.1)));
}

TEST(FindGrazedArcs, LeavesASurfaceThatIsSeenBesideTheShellOnly) {
  EXPECT_TRUE(isGrazed(with(&Left::nearest, 0.002)));
  EXPECT_FALSE(isGrazed(with(&Left::nearest, 0.006)));
}

}  // namespace tank_datum::hidden_by_edge_test
