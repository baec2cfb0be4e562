#include <gtest/gtest.h>

#include <cmath>

#include "support/scanned_tanks.h"
#include "tank_datum/datum.h"

namespace tank_datum::leaning_tank_test {

using namespace scanned_tanks;

/// Largest mean error of a quarter of the ring [m].
double worstQuarter(const Datum& datum, const synth::TruthTank& truth) {
  double worst = 0;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    double sum = 0;
    for (std::size_t k = 45 + 90 * quarter; k < 135 + 90 * quarter; ++k)
      sum += datum.stations[k % 360].z + datum.origin.z() - truth.stations[k % 360].z;
    worst = std::max(worst, std::abs(sum / 90.0));
  }
  return worst;
}

TEST(ExtractDatum, OfAShellThatLeansIsTheTruth) {
  SceneOptions scene = tank20();
  scene.tanks[0].lean_x = 0.03;
  scene.scanner.step = radians(0.25), scene.scanner.row_step = radians(0.12);
  scene.scanner.min_elevation = radians(-25), scene.scanner.max_elevation = radians(20);
  const Datum datum = extractDatum(Scan::fromPoints(pointsOf(scene)), {});
  ASSERT_EQ(datum.level.measured, 360U) << datum.message;
  EXPECT_LT(worstQuarter(datum, truthOf(scene)), 0.0004);  // about the middle of the seen shell's axis it is 2 mm
}

}  // namespace tank_datum::leaning_tank_test
