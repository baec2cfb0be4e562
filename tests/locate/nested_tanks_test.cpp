#include "locate/nested_tanks.h"

#include <gtest/gtest.h>

namespace tank_datum::nested_tanks_test {

/// A tank seen all round on the ground, as a sample with so long voxels shows it.
Tank tankOf(double radius, double height, double foot = 0.0, double resolution = 0.05) {
  Tank tank;
  tank.circle = {{3.0, 4.0}, radius};
  tank.foot.coefficients = Eigen::Vector3d(foot, 0.0, 0.0);
  tank.height = height;
  tank.coverage = 4.0;
  tank.resolution = resolution;
  return tank;
}

/// The radius of the only one that is left.
double leftOf(std::vector<Tank> tanks) {
  dropNested(tanks);
  return tanks.size() == 1 ? tanks[0].circle.radius : 0.0;
}

TEST(DropNested, OfOneShellFoundTwiceTheFinerStaysUnlessTheCoarserSawAQuarterMore) {
  const Tank fine = tankOf(10.0, 8.0, 0.0, 0.05);
  Tank coarse = tankOf(10.01, 8.0, 0.0, 0.1);
  coarse.coverage = 1.2 * fine.coverage;
  EXPECT_EQ(leftOf({fine, coarse}), 10.0);
  coarse.coverage = 1.3 * fine.coverage;
  EXPECT_EQ(leftOf({fine, coarse}), 10.01);
  coarse.coverage = 0.9 * fine.coverage;
  EXPECT_EQ(leftOf({coarse, fine}), 10.0);
}

TEST(DropNested, OfOneShellFoundTwiceTheOneBesideWhichAFoundationIsSeenStays) {
  Tank fine = tankOf(10.0, 8.0, 0.0, 0.05), coarse = tankOf(10.01, 8.0, 0.0, 0.1);
  coarse.coverage = 1.5 * fine.coverage;
  fine.has_foundation = true;
  EXPECT_EQ(leftOf({fine, coarse}), 10.0);
  coarse.has_foundation = true;
  EXPECT_EQ(leftOf({coarse, fine}), 10.01);
  fine.has_foundation = false;
  EXPECT_EQ(leftOf({fine, coarse}), 10.01);
}

TEST(DropNested, OfOneShellFoundTwiceOnOneRungTheSmallerStays) {
  EXPECT_EQ(leftOf({tankOf(10.0, 8.0), tankOf(10.01, 8.0)}), 10.0);
  EXPECT_EQ(leftOf({tankOf(10.01, 8.0), tankOf(10.0, 8.0)}), 10.0);
}

TEST(DropNested, OfOneShellFoundOnManyRungsTheFinestThatSawNearlyAsMuchAsAnyStays) {
  Tank fine = tankOf(10.0, 8.0, 0.0, 0.05), middle = tankOf(10.01, 8.0, 0.0, 0.1),
       coarse = tankOf(10.02, 8.0, 0.0, 0.4);
  middle.coverage = 1.2 * fine.coverage, coarse.coverage = 1.4 * fine.coverage;
  for (const auto& order : {std::vector<Tank>{fine, middle, coarse}, {coarse, middle, fine}, {middle, coarse, fine}})
    EXPECT_EQ(leftOf(order), 10.01);
}

TEST(DropNested, AHigherWallThatStandsDeeperUpToSixDecimetresOutsideIsARingwall) {
  const Tank shell = tankOf(10.0, 2.0);
  EXPECT_EQ(leftOf({shell, tankOf(10.58, 3.0, -3.5)}), 10.0);
  EXPECT_EQ(leftOf({shell, tankOf(10.62, 3.0, -3.5)}), 10.62);
  EXPECT_EQ(leftOf({shell, tankOf(10.35, 3.0, -3.5)}), 10.0);
}

/// The radius of what is left of a shell seen upon a ringwall 1 m high and of a wall whose foot is so much lower, seen
/// on coarser voxels half as far round again.
double leftOfShellAnd(double lower) {
  Tank shell = tankOf(10.0, 2.0), wall = tankOf(10.1, 2.0 + lower, -lower, 0.1);
  shell.ringwall_width = 0.2, shell.ringwall_height = 1.0;
  wall.coverage = 1.5 * shell.coverage;
  return leftOf({shell, wall});
}

TEST(DropNested, OfAShellUponARingwallAndAWallThatHoldsBothTheShellStays) {
  EXPECT_EQ(leftOfShellAnd(1.0), 10.0);
  EXPECT_EQ(leftOfShellAnd(0.55), 10.0);
  EXPECT_EQ(leftOfShellAnd(0.45), 10.1);
}

TEST(DropNested, OfABundWallAndATankTheHigherStays) {
  EXPECT_EQ(leftOf({tankOf(10.0, 8.0), tankOf(25.0, 1.5)}), 10.0);
  EXPECT_EQ(leftOf({tankOf(1.0, 2.0), tankOf(25.0, 12.0)}), 25.0);
}

/// The radius of what is left of a tank, seen from outside upon its foundation, and a circle of 20 m round it.
double leftOfTankIn(Side side, double radius, double height, double outer_height, double foot = 0.0) {
  Tank tank = tankOf(radius, height, foot), wall = tankOf(20.0, outer_height);
  tank.has_foundation = wall.has_foundation = true;
  wall.side = side;
  return leftOf({wall, tank});
}

TEST(DropNested, AHigherWallRoundATankThatIsSeenFromWithinIsNone) {
  EXPECT_EQ(leftOfTankIn(Side::Inside, 8.0, 1.3, 1.6), 8.0) << "cut below the bund's top";
  EXPECT_EQ(leftOfTankIn(Side::Inside, 17.0, 7.0, 9.0), 17.0) << "a cup";
  EXPECT_EQ(leftOfTankIn(Side::Inside, 17.0, 4.6, 9.0), 17.0);
  EXPECT_EQ(leftOfTankIn(Side::Inside, 17.0, 4.4, 9.0), 20.0) << "a thing in a tank";
  EXPECT_EQ(leftOfTankIn(Side::Inside, 3.1, 1.3, 1.6), 3.1);
  EXPECT_EQ(leftOfTankIn(Side::Inside, 2.9, 1.3, 1.6), 20.0) << "a column";
}

TEST(DropNested, ALowWallThatEndsBelowWhatStandsOnItIsNoTank) {
  EXPECT_EQ(leftOfTankIn(Side::Outside, 19.2, 1.4, 1.5, 1.5), 19.2);
  EXPECT_EQ(leftOfTankIn(Side::Outside, 19.2, 1.4, 2.1, 2.1), 20.0);
  EXPECT_EQ(leftOfTankIn(Side::Outside, 10.2, 1.4, 1.5, 1.5), 10.2);
  EXPECT_EQ(leftOfTankIn(Side::Outside, 9.8, 1.4, 1.5, 1.5), 20.0) << "upon a roof";
}

TEST(DropNested, TanksBesideEachOtherStay) {
  Tank beside = tankOf(5.0, 8.0);
  beside.circle.center.x() += 16.0;
  std::vector<Tank> tanks{tankOf(10.0, 8.0), beside};
  dropNested(tanks);
  EXPECT_EQ(tanks.size(), 2U);
}

}  // namespace tank_datum::nested_tanks_test
