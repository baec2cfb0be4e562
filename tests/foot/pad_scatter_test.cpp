#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::pad_scatter_test {

using namespace made_feet;

/// What is learnt of what points scatter by about a pad.
double scatterOf(MadeFoot& made) {
  const Foot& foot = made.foot();
  FootSections sections;
  FootProfile& whole = sections.whole;
  whole.bin = 0.003, whole.band_from = 0.015, whole.band_to = whole.edge = 0.3;
  whole.blur = 0.004, whole.noise = 0.003, whole.surface = Surface::Foundation;
  whole.height.assign(100, 0.0);
  sections.stations = 360;
  return learnPriors(foot, {{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)}, sections).scatter;
}

TEST(PadScatter, OfASmoothPadIsSmallThoughItsSlopeGoesUpAndDownRoundTheTank) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const double slope = -0.03 + 0.015 * std::cos(2.0 * s * made.step());
    made.addStation(s, 40, 0.02, 0.28, [slope](double d) { return slope * d; });
  }
  EXPECT_LT(scatterOf(made), 0.0004);
}

TEST(PadScatter, IsThatOfPlacesWhereManyRowsAreSeen) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s < 90) {  // bumps and hollows
      double bump = 0.001;
      made.addStation(s, 40, 0.02, 0.28, [&bump](double) { return bump = -bump; });
    } else {  // a row that creeps out, whose points lie in the plane of its rays
      const double d = 0.02 + 0.026 * ((s + 5) % 10);  // one in each window
      made.addStation(s, 40, d, d + 0.002, [](double at) { return 0.1 * (at - 0.15); });
    }
  }
  EXPECT_NEAR(scatterOf(made), 0.0015, 0.0003);
}

}  // namespace tank_datum::pad_scatter_test
