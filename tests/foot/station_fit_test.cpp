#include <gtest/gtest.h>

#include "support/made_feet.h"

namespace tank_datum::station_fit_test {

using namespace made_feet;

/// Points by turns so far above and below a surface that they scatter by `noise` in a robust sense.
class Scatter {
 public:
  explicit Scatter(double noise) : off_(noise / 1.4826) {}
  double next() { return off_ = -off_; }

 private:
  double off_;
};

FootProfile padOf(double noise) {
  FootProfile pad;
  pad.bin = 0.003, pad.band_from = 0.015, pad.band_to = pad.edge = 0.3;
  pad.blur = 0.0005, pad.noise = noise, pad.surface = Surface::Foundation;
  return pad;
}

FootPriors priorsOf(double sigma_slope, bool settled) {
  FootPriors priors;
  priors.slope.assign(360, 0.0);
  priors.sigma_slope.assign(360, sigma_slope);
  priors.sigma_bend = 1e-6;
  priors.settled = settled;
  return priors;
}

/// How many times its own stretch a station looks at, where each has so many points between two distances.
double windowOf(int points, double noise, double from, double to, const FootPriors& priors) {
  MadeFoot made;
  made.options.widest_window = 10.0;
  Scatter scatter(noise);
  made.addAll(points, from, to, [&](double) { return scatter.next(); });
  const Foot& foot = made.foot();
  return fitStation(foot, 100, 0.0, padOf(noise), priors).half_width / foot.half_step;
}

TEST(FitStation, AWindowGrowsUntilTheLevelIsKnownToAFifthOfAMillimetre) {
  // 3 mm over the root of 40 points are 0.48 mm: 5.9 times as many are wanted
  EXPECT_NEAR(windowOf(40, 0.003, 0.02, 0.28, priorsOf(1e-4, true)), std::pow(1.4, 6), 1e-9);
}

/// 60 points within a centimetre tell the level to 0.13 mm, and nothing of the slope.
TEST(FitStation, ASlopeIsTakenToBeKnownToThreeMillimetresAMetreForTheWindow) {
  const FootPriors open = priorsOf(0.1, false);
  EXPECT_NEAR(windowOf(60, 0.001, 0.035, 0.045, open), 1.0, 1e-9) << "0.12 mm from the slope";
  EXPECT_NEAR(windowOf(60, 0.001, 0.095, 0.105, open), std::pow(1.4, 9), 1e-9) << "0.3 mm: to ten degrees in vain";
}

TEST(FitStation, ASlopeThatIsSettledIsLearntNoFurtherThanATenthOfAMillimetreAMetre) {
  // a slope that the points tell as well as it is believed not to be there
  MadeFoot made;
  made.options.wanted_sigma = 1.0;
  made.addAll(12, 0.02, 0.28, [](double d) { return 0.0002 * d; });
  const FootFit fit = fitStation(made.foot(), 100, 0.0, padOf(3.85e-5), priorsOf(0.001, true));
  EXPECT_NEAR(fit.slope / 0.0002, 0.5, 0.15);
  EXPECT_NEAR(fit.half_width, made.step() / 2.0, 1e-9);
}

TEST(FitStation, TheLevelOfASettledSlopeIsAsSureAsTheSlopeInTheMiddle) {
  MadeFoot made;
  made.addAll(400, 0.02, 0.28, [](double) { return 0.0; });
  const FootFit fit = fitStation(made.foot(), 100, 0.0, padOf(1e-5), priorsOf(0.01, true));
  EXPECT_NEAR(fit.sigma, 0.15 * 0.01, 0.00005);
}

/// How many times its own stretch a station looks at that knows its level to 0.48 mm, where all beyond lies higher.
double windowBesideSteps(double high) {
  MadeFoot made;
  made.options.widest_window = 10.0;
  Scatter scatter(0.003);
  for (int s = 0; s < 360; ++s)
    made.addStation(s, 40, 0.02, 0.28, [&](double) { return scatter.next() + (s == 100 ? 0.0 : high); });
  const Foot& foot = made.foot();
  FootProfile pad = padOf(0.003);
  pad.blur = 0.05;
  return fitStation(foot, 100, 0.0, pad, priorsOf(1e-4, true)).half_width / foot.half_step;
}

TEST(FitStation, AWindowGrowsOnlyAsLongAsWiderOnesAgreeWithNarrowerOnes) {
  EXPECT_EQ(windowBesideSteps(0.0015), windowBesideSteps(0.0));
  EXPECT_LT(windowBesideSteps(0.003), 0.5 * windowBesideSteps(0.0));
}

/// How many times its own stretch a station looks at that may not look beyond two stations, where every n-th station
/// has so many points.
double sparseWindow(int points, int every) {
  MadeFoot made;
  made.options.widest_window = 0.2;
  for (int s = 100 % every; s < 360; s += every) {
    for (int i = 0; i < points; ++i) made.add(s * made.step(), 0.03 + 0.02 * i, i % 2 == 0 ? 0.002 : -0.002);
  }
  const Foot& foot = made.foot();
  return fitStation(foot, 100, 0.0, padOf(0.003), priorsOf(1e-4, true)).half_width / foot.half_step;
}

TEST(FitStation, AWindowWithFewerThanEightPointsGrowsBeyondWhatWasAskedFor) {
  // the outermost point of a station may lie on the surface's end and is not looked at
  EXPECT_NEAR(sparseWindow(5, 1), std::pow(1.4, 3), 1e-9) << "twelve points in three stations";
  EXPECT_NEAR(sparseWindow(3, 1), std::pow(1.4, 5), 1e-9) << "six in three, ten in five";
}

TEST(FitStation, ASparseWindowGrowsToFiveDegreesEitherWay) {
  EXPECT_NEAR(sparseWindow(1, 3), std::pow(1.4, 7), 1e-9) << "half a degree times so much is 5.3";
}

}  // namespace tank_datum::station_fit_test
