#include "foot/station_section.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tank_datum::station_section_test {

constexpr double kRadius = 10.0, kBand = 0.2;

/// A shell that leans outwards by 0.01, upon a pad that falls by 0.05 outwards and rises by 0.002 along the shell, and
/// whose edge drops steeply at 0.3 m. The foot lies at z = 2 at azimuth 1.
Points corner(int per_part) {
  Points points;
  const auto add = [&points](double azimuth, double radius, double z) {
    points.emplace_back(radius * std::cos(azimuth), radius * std::sin(azimuth), z);
  };
  for (int i = 0; i < per_part; ++i) {
    const double part = (i + 0.5) / per_part, azimuth = 1.0 + 0.008 * (part - 0.5), along = kRadius * (azimuth - 1.0);
    const double foot = 2.0 + 0.002 * along;
    add(azimuth, kRadius + 0.01 * 0.4 * part, foot + 0.4 * part);
    add(azimuth, kRadius + 0.3 * part, foot - 0.05 * 0.3 * part);
    add(azimuth, kRadius + 0.3, foot - 0.015 - 0.3 * part);
  }
  return points;
}

FootRing ringOf(const Points& points) {
  ShellLine line;
  line.radius = kRadius;
  line.points = 10;
  return FootRing(PolarRing(points, {0.0, 0.0}), ShellModel(std::vector<ShellLine>(360, line), 0.0), 1.0, 0.5);
}

ProfileWindow window(double half_step = 0.004) { return {1.0, half_step, 2.0, 0.5, {kBand, 1.0}}; }

FootFit fitOfThePad() {
  FootFit fit;
  fit.z = 2.0, fit.sigma = 0.0001, fit.slope = -0.05, fit.along = 0.002, fit.bend = 0.0, fit.noise = 0.0003;
  fit.half_width = 0.004;
  return fit;
}

ShellLine leaning() {
  ShellLine line;
  line.points = 10;
  line.lean = 0.01, line.noise = 0.0007;
  return line;
}

TEST(ProfileOf, KeepsAThirdOfEachPartAtMost) {
  const StationProfile profile = profileOf(ringOf(corner(500)), window(), fitOfThePad(), leaning(), 30);
  ASSERT_LE(profile.points.size(), 30U);
  int shell = 0, pad = 0, rest = 0;
  for (const SectionPoint& p : profile.points) {
    if (p.z > p.d) {
      ++shell;
    } else if (p.d <= kBand && p.z > -0.02) {
      ++pad;
    } else {
      ++rest;
    }
  }
  EXPECT_GE(shell, 8);
  EXPECT_GE(pad, 8);
  EXPECT_GE(rest, 8);
  EXPECT_GT(profileOf(ringOf(corner(500)), window(), fitOfThePad(), leaning(), 90).points.size(), 60U);
}

TEST(ProfileOf, PointsLieOnItsLines) {
  const StationProfile profile = profileOf(ringOf(corner(500)), window(), fitOfThePad(), leaning(), 60);
  EXPECT_EQ(profile.base, 2.0);
  EXPECT_EQ(profile.foundation, 0.0);
  EXPECT_EQ(profile.noise, 0.0003);
  EXPECT_EQ(profile.shell_noise, 0.0007);
  for (const SectionPoint& p : profile.points) {
    if (p.z > p.d) {
      EXPECT_NEAR(p.d, profile.lean * p.z, 2e-6);
    } else if (p.d < 0.29) {
      EXPECT_NEAR(p.z, profile.slope * p.d, 2e-6);  // what rises along the shell is taken out
    }
  }
}

TEST(ProfileOf, SeenFromInsideLeansTheOtherWay) {
  ProfileWindow inside = window();
  inside.band.side = -1.0;
  EXPECT_EQ(profileOf(ringOf(corner(50)), inside, fitOfThePad(), leaning(), 60).lean, -0.01);
}

TEST(ProfileOf, AStationWithFewPointsTakesItsFitsWindow) {
  const ProfileWindow narrow = window(0.0001);
  const FootRing ring = ringOf(corner(200));
  const auto own = profileOf(ring, narrow, {}, leaning(), 300).points.size();
  EXPECT_GT(profileOf(ring, narrow, fitOfThePad(), leaning(), 300).points.size(), 10 * own);
}

TEST(ProfileOf, WithoutFitsHasPointsAndNoLines) {
  const StationProfile profile = profileOf(ringOf(corner(100)), window(), {}, {}, 60);
  EXPECT_FALSE(profile.hasFoundation());
  EXPECT_FALSE(profile.hasShell());
  EXPECT_GT(profile.points.size(), 30U);
  EXPECT_TRUE(std::isnan(profile.slope) && std::isnan(profile.noise) && std::isnan(profile.shell_noise));
}

TEST(ProfileOf, OfNothingIsEmpty) { EXPECT_TRUE(profileOf(ringOf({}), window(), {}, {}, 60).points.empty()); }

}  // namespace tank_datum::station_section_test
