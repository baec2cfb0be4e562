#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "support/made_sections.h"

namespace tank_datum::foot_band_test {

using namespace made_sections;

/// A rough pad with something on it, beyond which it is even.
double roughBeforeAnObject(double d) {
  constexpr double kStep = 0.03;
  if (d > 0.225) return d < 0.231 ? 0.003 : 0.0;
  return 0.005 * (std::fmod(d + kStep, kStep) - 0.5 * kStep);
}

TEST(StackProfile, TheBandIsTheWidestWhereTheFlattestIsASmallPart) {
  const FootProfile profile = MadeFoot(roughBeforeAnObject, 2000).profile();
  EXPECT_LT(profile.band_from, 0.03);
  EXPECT_GT(profile.band_to, 0.21);
}

TEST(StackProfile, TheBandIsTheWidestOfAFoundationOnly) {
  const auto band = [](double slope) {
    return MadeFoot([=](double d) { return roughBeforeAnObject(d) + slope * d; }, 2000).profile();
  };
  EXPECT_LT(band(-0.045).band_from, 0.05);
  EXPECT_GT(band(-0.06).band_from, 0.05);
}

TEST(StackProfile, TheBandLiesAboutTheFlattestWhereThatIsHalfOfTheSurface) {
  const auto stepped = [](double d) {
    return d < 0.16 ? 0.005 * (std::fmod(d, 0.03) - 0.015) : d < 0.17 ? 0.003 : 0.0;
  };
  EXPECT_LT(MadeFoot(stepped, 2000).profile().band_to, 0.165);
  const auto half = [](double d) { return d < 0.13 ? 0.005 * (std::fmod(d, 0.03) - 0.015) : d < 0.14 ? 0.003 : 0.0; };
  EXPECT_GT(MadeFoot(half, 2000).profile().band_from, 0.13);
}

/// A lip that is level for 60 mm, and falls from there to a gap before a crown, where one point in four is seen.
FootProfile bentDown(double fall) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.0018);
  std::vector<FootPoint> points;
  for (int i = 0; i < 16000; ++i) {
    const double d = 0.3 * (i + 0.5) / 16000, z = d < 0.060 ? 0.0 : d < 0.126 ? -fall * (d - 0.060) : 0.012;
    if (d < 0.095 || i % 4 == 0) points.push_back({0.0, d, z + noise(random)});
  }
  return stackProfile({points}, {0.0}, {0.3, 0.0027, 0.013});
}

TEST(StackProfile, WhatLiesMoreThanAMillimetreBelowTheBandsLineBesideTheShellIsTheSurface) {
  EXPECT_GT(bentDown(0.05).band_from, 0.035);
  EXPECT_LT(bentDown(0.06).band_from, 0.018);
  EXPECT_NEAR(bentDown(0.06).offset, 0.0, 0.0003);
}

}  // namespace tank_datum::foot_band_test
