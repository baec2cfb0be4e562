#include <gtest/gtest.h>

#include "support/made_feet.h"

namespace tank_datum {
namespace {

using namespace made_feet;

/// Whether a station on a level pad is dropped beside which the shell is seen by so many points a centimetre below the
/// pad, and by so many up to two above it.
bool isDropped(int below, int above) {
  MadeFoot made;
  made.addAll(40, 0.02, 0.28, [](double) { return 0.0; });
  for (int i = 0; i < below; ++i) made.add((50 - 0.2 + 0.4 * i / below) * made.step(), 0.0, -0.010);
  for (int i = 0; i < above; ++i) made.add((50 - 0.2 + 0.4 * i / above) * made.step(), 0.0, 0.004 + 0.014 * i / above);
  Foot& foot = made.foot();
  FootFit fit;
  fit.z = fit.slope = fit.along = fit.bend = 0.0;
  fit.sigma = 0.0002, fit.noise = 0.0004, fit.sigma_slope = 0.001, fit.half_width = foot.half_step;
  FootPass pass;
  pass.fits.assign(360, fit);
  pass.priors.slope.assign(360, 0.0);
  pass.sections.stations = 360;
  FootProfile& pad = pass.sections.whole;
  pad.bin = 0.003, pad.band_from = 0.015, pad.noise = 0.0005, pad.band_to = pad.edge = 0.3;
  return findOutliers(foot, {{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)}, pass)[50] !=
         Unmeasured::None;
}

TEST(FindOutliers, AShellSeenBelowAQuarterAsOftenAsAboveGoesOn) {
  EXPECT_FALSE(isDropped(8, 40));
  EXPECT_TRUE(isDropped(13, 40));
}

TEST(FindOutliers, ThreePointsBelowAreStrayHoweverFewAreAbove) {
  EXPECT_FALSE(isDropped(3, 8));
  EXPECT_TRUE(isDropped(4, 8));
}

}  // namespace
}  // namespace tank_datum
