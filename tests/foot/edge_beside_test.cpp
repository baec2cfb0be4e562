#include <gtest/gtest.h>

#include "support/made_narrow_lips.h"

namespace tank_datum::edge_beside_test {

using namespace made_narrow_lips;

constexpr double kEnds = 0.016;  // where the shell does, above the surface [m]

/// Adds what stands `out` beyond a weld of the height at which the shell ends, so many points to a station.
void addBeyond(MadeFoot& made, int points, double out) {
  for (int k = 0; k < points; ++k) {
    const double height = kEnds * (0.2 + 0.6 * (k + 0.5) / points), d = kEnds - height + out;
    made.addAll(1, d, d, [height](double) { return height; });
  }
}

/// A shell that ends above the surface, and so many points to a station of an edge; and of a weld.
Scene endsAbove(int edge, double out, int weld = 0) {
  Scene scene;
  scene.has_lip = [](int) { return false; };
  scene.noise = 0.0003, scene.shell_noise = 0.0006;
  scene.add = [=](MadeFoot& made) {
    made.addAll(60, 0.0, 0.0011, [](double d) { return 0.049 - (0.049 - kEnds) * d / 0.0011; });
    addBeyond(made, edge, out);
    addBeyond(made, weld, 0.0);
  };
  return scene;
}

TEST(EdgeBeside, HalfOfTheHeightAtWhichTheShellEndsIsInSigma) {
  const Lift lift = lipsOf(endsAbove(20, 0.009))[100];
  EXPECT_EQ(lift.height, 0.0) << "nothing is raised";
  EXPECT_NEAR(lift.sigma, 0.5 * kEnds, 0.0005);
}

TEST(EdgeBeside, OnAPlateIsItsWeld) {
  Scene edge = endsAbove(20, 0.009);
  edge.add = [all = edge.add](MadeFoot& made) {
    all(made);
    made.addAll(20, 0.002, 0.029, [](double) { return 0.0; });
  };
  EXPECT_GT(lipsOf(edge)[100].sigma, 0.0);
  EXPECT_EQ(lipsOf(edge, true)[100].sigma, 0.0);
}

TEST(EdgeBeside, StandsOutFartherThanAWeld) {  // and five standard deviations of noise, 3 mm
  EXPECT_EQ(lipsOf(endsAbove(20, 0.0))[100].sigma, 0.0);
  EXPECT_EQ(lipsOf(endsAbove(20, 0.0027))[100].sigma, 0.0);
  EXPECT_GT(lipsOf(endsAbove(20, 0.0050))[100].sigma, 0.0);
}

TEST(EdgeBeside, IsOfEightPointsAtLeast) {  // of five stations together
  const auto sigma_of = [](int edge) {
    Scene sparse = endsAbove(edge, 0.009);
    sparse.density = 500.0;
    sparse.add = [all = sparse.add](MadeFoot& made) {
      all(made);
      made.addAll(8, 0.004, 0.029, [](double) { return 0.0; });  // what an edge does not hide
    };
    return lipsOf(sparse)[100].sigma;
  };
  EXPECT_EQ(sigma_of(1), 0.0);
  EXPECT_GT(sigma_of(2), 0.0);
}

TEST(EdgeBeside, StandsAboveTheSurfacesNoise) {
  const auto sigma_of = [](double height) {
    Scene low = endsAbove(0, 0.0);
    low.noise = 0.002;
    low.add = [shell = low.add, height](MadeFoot& made) {
      shell(made);
      made.addAll(20, 0.005, 0.028, [height](double) { return height; });
    };
    return lipsOf(low)[100].sigma;
  };
  EXPECT_EQ(sigma_of(0.0030), 0.0);
  EXPECT_GT(sigma_of(0.0050), 0.0);
}

TEST(EdgeBeside, IsAQuarterOfWhatStandsThereAtLeast) {
  EXPECT_EQ(lipsOf(endsAbove(10, 0.009, 40))[100].sigma, 0.0);
  EXPECT_GT(lipsOf(endsAbove(10, 0.009, 25))[100].sigma, 0.0);
}

}  // namespace tank_datum::edge_beside_test
