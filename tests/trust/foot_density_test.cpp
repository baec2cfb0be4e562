#include "trust/foot_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_density_test {

constexpr double kRadius = 5.0;

/// A point every tenth of a degree of an arc, so far beside the shell and above its foot.
void addRow(Ring& ring, double beside, double above, double degrees) {
  for (int i = 0; i < std::lround(10.0 * degrees); ++i) {
    const double a = toRadians(0.1 * i), r = kRadius + beside;
    ring.points.emplace_back(1.0 + r * std::cos(a), r * std::sin(a), 0.25 + above);
  }
}

double densityOf(double beside, double above, Side side, double degrees = 360.0, double coverage = 0.0) {
  Tank tank;
  tank.circle = {{1.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d(0.25, 0.0, 0.0);
  tank.side = side;
  tank.coverage = toRadians(coverage > 0.0 ? coverage : degrees);
  Ring ring;
  ring.reach = 0.5;
  addRow(ring, beside, above, degrees);
  addRow(ring, 0.0, 0.3, degrees);  // of the shell
  return footDensity(ring, tank);
}

TEST(FootDensity, CountsPointsADegreeBesideTheFootOnTheFoundationsSide) {
  EXPECT_NEAR(densityOf(0.1, 0.0, Side::Outside), 10.0, 1e-9);
  EXPECT_NEAR(densityOf(0.1, 0.0, Side::Outside, 90.0), 10.0, 1e-9);
  EXPECT_NEAR(densityOf(0.1, 0.0, Side::Outside, 87.0), 10.0, 1e-9);
  EXPECT_NEAR(densityOf(0.1, 0.0, Side::Outside, 90.0, 360.0), 10.0, 1e-9) << "hidden elsewhere";
  EXPECT_NEAR(densityOf(0.1, 0.0, Side::Outside, 92.0, 360.0), 920.0 / 95.0, 1e-9) << "by sectors of five degrees";
  EXPECT_NEAR(densityOf(-0.1, 0.0, Side::Inside), 10.0, 1e-9);
  EXPECT_TRUE(std::isnan(densityOf(0.1, 0.0, Side::Inside)));
}

TEST(FootDensity, LeavesOutTheShellAndWhatLiesHigherOrFurtherOff) {
  EXPECT_TRUE(std::isnan(densityOf(0.015, 0.0, Side::Outside)))
      << "a twenty-fifth of the reach is the shell's own blur";
  EXPECT_NEAR(densityOf(0.025, 0.0, Side::Outside), 10.0, 1e-9);
  EXPECT_TRUE(std::isnan(densityOf(0.51, 0.0, Side::Outside)));
  EXPECT_NEAR(densityOf(0.1, -0.06, Side::Outside), 10.0, 1e-9);
  EXPECT_TRUE(std::isnan(densityOf(0.1, 0.09, Side::Outside)));
}

TEST(FootDensity, OfASparseFootAWordIsSaid) {
  EXPECT_EQ(sparseFoot(1.23), "1.2 foundation points a degree; some 20 are needed");
  EXPECT_EQ(sparseFoot(13.0), "13 foundation points a degree; some 20 are needed");
  EXPECT_EQ(sparseFoot(25.0), "");
  EXPECT_EQ(sparseFoot(kUnknown), "");
}

TEST(FootDensity, OfStationsFinerThanThePointsAWordIsSaid) {
  EXPECT_EQ(fineStations(26.0, 7200),
            "7200 stations are finer than the points of the foot: ask for fewer (option stations)");
  EXPECT_NE(fineStations(3.9, 720), "");
  EXPECT_EQ(fineStations(4.1, 720), "");
  EXPECT_EQ(fineStations(0.5, 360), "") << "the foot is sparse, then";
  EXPECT_EQ(fineStations(kUnknown, 7200), "");
}

}  // namespace tank_datum::foot_density_test
