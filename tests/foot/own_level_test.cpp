#include "foot/own_level.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::own_level_test {

using namespace made_feet;

constexpr double kNoise = 0.0005;  // of the foot that levelPass() found

/// A ring of lips 45 mm wide at z = 0, and a station that shows a surface so high, within half of its own stretch and
/// of those beside it.
struct Raised {
  double height = 0.040;
  double slope = 0.0;  ///< outwards [m/m]
  double along = 0.0;  ///< [m/m]
  int points = 40;     ///< on it
  int others = 0;      ///< off it, anywhere
  double rough = kNoise;
  double wide = 1.6;  ///< of a station's stretch

  FootFit fit() const {
    MadeFoot made;
    for (int s = 0; s < 360; ++s) {
      if (s < 49 || s > 51) made.addStation(s, 40, 0.0155, 0.0595, [](double) { return 0.0; });
    }
    const auto share = [](int i, double by) { return std::fmod(by * (i + 1), 1.0) - 0.5; };
    for (int i = 0; i < points + others; ++i) {
      const double turn = wide * share(i, 0.754878) * made.step(), d = 0.0375 + 0.04 * share(i, 0.569840);
      const double off = i < points ? 3.46 * rough * share(i, 0.618034) : 0.1 * share(i, 0.618034);
      made.add(50 * made.step() + turn, d, height + slope * d + along * turn * kRadius + off);
    }
    return fitAtOwnLevel(made.foot(), 50, levelPass(0.0, 0.06));
  }
};

TEST(FitAtOwnLevel, IsThePlaneOfTheStationsPointsHoweverHigh) {
  for (const double height : {-0.2, 0.04, 0.3}) {
    Raised raised{height};
    raised.slope = -0.05, raised.along = 0.1;
    const FootFit fit = raised.fit();
    ASSERT_TRUE(fit.valid());
    EXPECT_NEAR(fit.z, height, 0.001);
    EXPECT_NEAR(fit.slope, -0.05, 0.02);
    EXPECT_NEAR(fit.along, 0.1, 0.005);
    EXPECT_NEAR(fit.noise, kNoise, 0.5 * kNoise);
  }
}

TEST(FitAtOwnLevel, OfFewerThanTwelvePointsThereIsNone) {
  Raised raised;
  raised.points = 12;
  EXPECT_TRUE(raised.fit().valid());
  raised.points = 11;
  EXPECT_FALSE(raised.fit().valid());
}

TEST(FitAtOwnLevel, WhatIsThriceAsRoughAsTheFootIsNone) {
  Raised raised;
  raised.points = 200;
  raised.rough = 2.0 * kNoise;
  EXPECT_TRUE(raised.fit().valid());
  raised.rough = 4.0 * kNoise;
  EXPECT_FALSE(raised.fit().valid());
}

TEST(FitAtOwnLevel, HalfOfThePointsLieOnIt) {
  Raised raised;
  raised.others = 30;
  EXPECT_TRUE(raised.fit().valid());
  raised.others = 60;
  EXPECT_FALSE(raised.fit().valid());
}

TEST(FitAtOwnLevel, WhereNothingIsSeenThereIsNone) {
  Raised raised;
  raised.points = 0;
  EXPECT_FALSE(raised.fit().valid());
}

TEST(FitAtOwnLevel, HalfOfTheStretchesBesideIsLookedAt) {
  Raised raised;
  raised.points = 20;
  raised.wide = 1.9;
  EXPECT_EQ(raised.fit().points, 20U);
  raised.wide = 4.0;
  EXPECT_FALSE(raised.fit().valid());
}

}  // namespace tank_datum::own_level_test
