#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_analyses.h"

namespace tank_datum::stated_errors_test {

using namespace made_surveys;

/// Sigmas of millimetres typed as metres, or by far too careful: no figure is then 0 to 0 of its limit.
TEST(Analyse, SigmasFarBeyondWhatIsSeenAreSaidAndHoldTheFigure) {
  const auto plane = wave(24, [](double a) { return 0.02 * std::cos(a - 0.7); });
  for (const double sigma : {0.02, 1.0}) {
    const Analysis found = analysed(plane, 30.0, sigma);
    EXPECT_TRUE(notes(found, "in the unit of the elevations?")) << sigma;
    for (const Measure& m : found.measures) {
      if (m.quantity != "slope_10m" && m.quantity != "neighbour_slope" && m.quantity != "level_9m") continue;
      EXPECT_LE(m.interval.low, m.worst.value) << m.quantity;
      EXPECT_GE(m.interval.high, m.worst.value) << m.quantity;
    }
  }
  const auto seen = wave(24, [](double a) { return 0.02 * std::cos(a - 0.7) + 0.001 * std::cos(7 * a); });
  EXPECT_FALSE(notes(analysed(seen, 30.0, 0.0015), "in the unit of"));  // of 0.7 mm RMS
  EXPECT_TRUE(notes(analysed(seen, 30.0, 0.003), "in the unit of"));
}

/// Of few points nothing is missing; what leaves the shape undecided is said in their distance.
TEST(Analyse, PointsTooFarApartAreNamed) {
  const Analysis apart = analysed(level(10), 30.0, 0.001);
  EXPECT_TRUE(notes(apart, "Neighbouring elevations are up to 18.8 m apart: beyond 9.75 m (32 ft) rules on the shape"));
  EXPECT_FALSE(notes(analysed(level(24), 30.0, 0.001), "Neighbouring elevations"));
  EXPECT_FALSE(notes(analysed(level(120), 30.0, 0.001), "Neighbouring elevations"));
}

}  // namespace tank_datum::stated_errors_test
