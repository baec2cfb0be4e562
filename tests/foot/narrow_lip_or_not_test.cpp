#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/made_narrow_lips.h"

namespace tank_datum::narrow_lip_or_not_test {

using namespace made_narrow_lips;

TEST(NarrowLips, AreNoFillets) {
  Scene mastic;
  mastic.has_lip = [](int) { return false; };
  mastic.noise = 0.0007;  // levels are 2.8 mm thick, 9 mm of it
  mastic.add = [](MadeFoot& made) { made.addAll(120, 0.004, 0.034, [](double d) { return 0.3 * (0.034 - d); }); };
  EXPECT_FALSE(isRaised(mastic));
}

/// A fillet whose upper part is level comes down to the surface; a lip's edge is upright.
TEST(NarrowLips, DoNotComeDown) {
  Scene mastic;
  mastic.has_lip = [](int) { return false; };
  const auto falling = [](double over) {
    return [over](MadeFoot& made) {
      made.addAll(40, 0.004, 0.016, [](double) { return 0.006; });
      made.addAll(18, 0.016, 0.016 + over, [over](double d) { return 0.006 * (1.0 - (d - 0.016) / over); });
    };
  };
  mastic.add = falling(0.014);
  EXPECT_FALSE(isRaised(mastic));
  EXPECT_NEAR(lipsOf(mastic)[100].sigma, 0.003, 0.0002);
  mastic.add = falling(0.009);
  EXPECT_TRUE(isRaised(mastic)) << "steeper than 0.5 m/m: what wide beams make of an edge";
}

TEST(NarrowLips, DoNotComeDownOverWhatNoiseLeavesBetweenTheSurfaces) {
  Scene mastic;
  mastic.has_lip = [](int) { return false; };
  mastic.noise = 0.0009;
  mastic.add = [](MadeFoot& made) {
    made.addAll(40, 0.004, 0.016, [](double) { return 0.006; });
    made.addAll(30, 0.016, 0.030, [](double d) { return 0.006 * (1.0 - (d - 0.016) / 0.014); });
  };
  EXPECT_FALSE(isRaised(mastic));
  Scene rough = mastic;
  const auto roughly = [](double height, double scatter) {
    return [=](MadeFoot& made) {
      std::mt19937_64 random(4);
      std::normal_distribution<double> noise(0.0, scatter);
      made.addAll(32, 0.003, 0.0186, [&](double) { return height + noise(random); });
      made.addAll(23, 0.0186, 0.030, [&](double) { return noise(random); });
    };
  };
  rough.noise = 0.0017;
  rough.add = roughly(0.0072, rough.noise);
  EXPECT_TRUE(isRaised(rough));
}

/// A weld's face before points that beams leave between lip and crown, and some below.
TEST(NarrowLips, UponAPlateAreNoWelds) {
  Scene weld;
  weld.has_lip = [](int) { return false; };
  weld.noise = 0.0009;
  weld.add = [](MadeFoot& made) {
    made.addAll(14, 0.004, 0.011, [](double d) { return 0.0063 - 0.4 * (d - 0.004); });
    made.addAll(8, 0.012, 0.029, [](double d) { return 0.003 + 0.09 * (d - 0.012); });
    made.addAll(7, 0.011, 0.030, [](double) { return 0.0026; });
  };
  EXPECT_EQ(lipsOf(weld, true)[100].height, 0.0);
  EXPECT_NEAR(lipsOf(weld, true)[100].sigma, 0.5 * 0.0063, 2e-4) << "it may be as high as its upper end";
}

/// A lip with one point at every so many stations, anywhere on it.
Scene sparseLip(int every, double to, double density) {
  Scene sparse;
  sparse.has_lip = [](int) { return false; };
  sparse.density = density;
  sparse.add = [every, to](MadeFoot& made) {
    for (int s = 0; s < 360; s += every) {
      const double d = 0.008 + (to - 0.008) * std::fmod(0.618034 * s, 1.0);
      made.addStation(s, 1, d, d, [](double) { return 0.008; });
    }
  };
  return sparse;
}

TEST(NarrowLips, OfSparseScansAreSeenWithinFifteenDegrees) {
  EXPECT_TRUE(isRaised(sparseLip(3, 0.026, 20.0))) << "ten points";
  EXPECT_FALSE(isRaised(sparseLip(5, 0.026, 20.0))) << "six";
}

TEST(NarrowLips, AreTwelvePointsOfTheNarrowestAtLeast) {
  EXPECT_TRUE(isRaised(sparseLip(1, 0.019, 132.0))) << "13 points beside 430 of the surface";
}

/// Scans show a weld's toe and the face of an edge more densely than the level part between.
TEST(NarrowLips, AreLevelBetweenToeAndFace) {
  Scene edge;
  edge.has_lip = [](int) { return false; };
  edge.noise = 0.0012;
  edge.add = [](MadeFoot& made) {
    made.addAll(30, 0.0040, 0.0103, [](double d) { return 0.008 + 0.4 * (0.0103 - d); });
    made.addAll(8, 0.0103, 0.0218, [](double) { return 0.008; });
    made.addAll(40, 0.0218, 0.0250, [](double d) { return 0.008 - 0.6 * (d - 0.0218); });
  };
  EXPECT_TRUE(isRaised(edge));
}

/// A shell seen from some height up, its points off it by up to 1.8 mm, the lowest farthest.
Scene unlit(double lowest) {
  Scene dark;
  dark.has_lip = [](int) { return false; };
  dark.add = [lowest](MadeFoot& made) {
    made.addAll(60, 0.0, 0.0018, [lowest](double d) { return 0.049 - (0.049 - lowest) * d / 0.0018; });
  };
  return dark;
}

TEST(NarrowLips, MayBeWhereNothingIsSeen) {
  const Lift dark = lipsOf(unlit(0.012))[100];
  EXPECT_EQ(dark.height, 0.0);
  EXPECT_NEAR(dark.sigma, 0.006, 0.0003);
  EXPECT_EQ(lipsOf(unlit(0.0))[100].sigma, 0.0) << "the shell meets the surface";
}

TEST(NarrowLips, AreAsHighWhereOneOfThemIsDark) {
  Scene some = unlit(0.02);
  some.has_lip = [](int s) { return s < 95 || s > 105; };
  const Lift dark = lipsOf(some)[100];
  EXPECT_NEAR(dark.height, 0.008, 1e-6);
  EXPECT_NEAR(dark.sigma, 0.004, 0.0005);
}

/// A cable lies upon a lip or a ringwall; of a lip upon a lip more is seen.
TEST(NarrowLips, OnAPlateAreWiderThanHigh) {
  EXPECT_GT(lipsOf(lip(0.008, 0.030, 0.0090), true)[100].height, 0.0);
  const Lift cable = lipsOf(lip(0.008, 0.030, 0.0120), true)[100];
  EXPECT_EQ(cable.height, 0.0);
  EXPECT_NEAR(cable.sigma, 0.006, 0.0002) << "half of what it may be";
  EXPECT_GT(lipsOf(lip(0.008, 0.030, 0.0120))[100].height, 0.0);
}

}  // namespace tank_datum::narrow_lip_or_not_test
