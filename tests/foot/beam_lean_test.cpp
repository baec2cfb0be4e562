#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "foot/foot_profile.h"
#include "foot/slanting_beams.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::beam_lean_test {

TEST(BeamLean, IsThatOfLevelLipsSeenByWideBeams) {
  // slopes fitted to level lips in a simulated scan with mixed pixels, by the rays' steepness, lip to 54 mm
  EXPECT_NEAR(beamLean(0.051, 0.054), 0.10, 0.035);
  EXPECT_NEAR(beamLean(0.074, 0.054), 0.06, 0.055);
  EXPECT_NEAR(beamLean(0.120, 0.054), 0.036, 0.035);
  EXPECT_EQ(beamLean(0.20, 0.054), 0.0);
  EXPECT_GT(beamLean(0.15, 0.054), 0.0);
  EXPECT_EQ(beamLean(0.051, 0.3), 0.0);  // a ringwall is wider than any footprint
}

TEST(RingBeamLean, IsNoLessThanWhatLevelLipsSeemToLeanByAndNotMuchMore) {
  // steepness, lip, and the slope of all windows in simulated scans with mixed pixels, 8 to 15 m from lips of 50, 65
  // and 90 mm with welds of 6 to 11 mm
  const auto lean = [](double steepness, double lip) { return ringBeamLean(steepness, lip, 0.013); };
  for (const auto& [steepness, lip, seen] : std::vector<std::array<double, 3>>{{0.247, 0.042, 0.0051},
                                                                               {0.250, 0.045, 0.0090},
                                                                               {0.189, 0.057, 0.0067},
                                                                               {0.246, 0.057, 0.0011},
                                                                               {0.147, 0.072, 0.0082}}) {
    EXPECT_GE(lean(steepness, lip), seen) << steepness << " " << lip;
    EXPECT_LE(lean(steepness, lip), 7.0 * seen) << steepness << " " << lip;
  }
  EXPECT_LE(lean(0.189, 0.081), 0.0006);
  EXPECT_NEAR(lean(0.0, 0.0515), 0.2, 1e-12) << "rays that graze: as steep as a beam is wide over the lip";
}

/// A plate of 60 mm, 10 mm above what it lies on, which slopes; lifted beside the edge as exp(-distance / 6 mm). What
/// it lies on goes up and down.
FootProfile edgeWith(double lift, double slope, double drop = 0.010, double uneven = 0.0) {
  FootProfile profile;
  profile.band_from = 0.015, profile.band_to = 0.055, profile.noise = 0.001, profile.blur = 0.004;
  profile.bin = 0.003, profile.edge = 0.060, profile.slope = profile.slope_beyond = slope;
  for (int i = 0; i < 60; ++i) {
    const double d = (i + 0.5) * profile.bin, beyond = d - profile.edge;
    const double ground = drop - lift * std::exp(-beyond / 0.006) + (i % 2 == 0 ? uneven : -uneven);
    profile.height.push_back(slope * d - (beyond > 0.0 ? ground : 0.0));
  }
  return profile;
}

double blendBeyond(const FootProfile& profile) { return blendLean(profile, 0.0) * profile.edge / 3.5; }

TEST(BlendBeyond, IsTheLiftNineToFifteenMillimetresBesideTheEdge) {
  EXPECT_NEAR(blendBeyond(edgeWith(0.003, 0.0)), 0.003 * std::exp(-12.0 / 6.0), 0.0001);
  EXPECT_NEAR(blendBeyond(edgeWith(0.003, -0.02)), 0.003 * std::exp(-12.0 / 6.0), 0.0001);
}

TEST(BlendBeyond, IsNoneWhereTheEdgeIsSharpOrNotSeen) {
  EXPECT_LT(blendBeyond(edgeWith(0.0, -0.02)), 1e-9);
  EXPECT_EQ(blendBeyond(edgeWith(0.001, 0.0, 0.0029)), 0.0);
  EXPECT_GT(blendBeyond(edgeWith(0.001, 0.0, 0.0031)), 0.0);
  FootProfile hidden = edgeWith(0.003, 0.0);
  hidden.height.resize(30);  // 30 mm beyond the edge
  EXPECT_EQ(blendBeyond(hidden), 0.0);
}

TEST(CrownRise, IsAQuarterOfTheLineFromTheLipsEndToWhatIsHigherThreeCentimetresBeyond) {
  FootProfile crown = edgeWith(0.0, -0.02, -0.006);
  EXPECT_NEAR(crownRise(crown), 0.25 * 0.006 / (0.060 + 0.015 - 0.055), 0.006);
  EXPECT_EQ(crownRise(edgeWith(0.0, -0.02, 0.006)), 0.0);
  crown.noise = 0.0031;
  EXPECT_EQ(crownRise(crown), 0.0) << "as uneven";
}

TEST(CrownRise, IsNoneWhereACrownHidesTheLipsEnd) {
  FootProfile hidden = edgeWith(0.0, 0.0, -0.006);
  hidden.band_to = 0.020;
  for (std::size_t i = 8; i < 20; ++i) hidden.height[i] = kUnknown;
  EXPECT_EQ(crownRise(hidden), 0.0);
}

TEST(BlendBeyond, IsWhatStandsOutOfAnUnevenGround) {
  const double even = blendBeyond(edgeWith(0.003, 0.0));
  EXPECT_NEAR(blendBeyond(edgeWith(0.003, 0.0, 0.010, 0.00005)), even - 2.0 * 1.4826 * 0.00005, 0.00006);
  EXPECT_EQ(blendBeyond(edgeWith(0.003, 0.0, 0.010, 0.00030)), 0.0);
}

TEST(BlendLean, WhatUnevenGroundMayHideCountsAsFarAsBeamsCanFeignIt) {
  const FootProfile uneven = edgeWith(0.003, 0.0, 0.010, 0.00005);
  const double surely = 3.5 * blendBeyond(uneven) / 0.060, hidden = 3.5 * 3.0 * 1.4826 * 0.00005 / 0.060;
  EXPECT_NEAR(blendLean(uneven, 0.1), surely + hidden, 0.05 * hidden);
  EXPECT_NEAR(blendLean(uneven, surely + 0.3 * hidden), surely + 0.3 * hidden, 1e-9);
  EXPECT_GT(surely, 0.0);
}

TEST(BlendLean, IsAllThatBeamsCanFeignWhereTooLittleIsSeenBeyond) {
  const auto seen_beyond = [](std::size_t bins) {
    FootProfile few = edgeWith(0.003, 0.0, 0.010);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < few.height.size(); ++i) {
      const double beyond = middle(few, i) - few.edge;
      if (beyond > 0.030 && beyond < 0.090 && ++seen > bins) few.height[i] = kUnknown;
    }
    return few;
  };
  EXPECT_EQ(blendLean(seen_beyond(3), 0.1), 0.1);
  EXPECT_LT(blendLean(seen_beyond(4), 0.1), 0.1);
}

TEST(BlendLean, OfWhatRisesBeyondAsBeamsInAGapBeforeACrownDoTellsNothing) {
  EXPECT_GT(blendLean(edgeWith(0.003, 0.04), 0.1), 0.01);
  EXPECT_EQ(blendLean(edgeWith(0.003, 0.06), 0.1), 0.0);
}

TEST(BlendLean, AllThatAPlateFallsByMayBeFeignedWhereItComesDownWithoutAStep) {
  const auto falling = [](double slope, double drop) {
    FootProfile ramp = edgeWith(0.0, 0.0, drop);
    ramp.slope = slope;
    return ramp;
  };
  EXPECT_NEAR(blendLean(falling(-0.07, 0.0070), 0.01), 0.07, 1e-12);  // 2.8 mm above what lies beyond
  EXPECT_LT(blendLean(falling(-0.07, 0.0074), 0.01), 0.01);
  EXPECT_NEAR(blendLean(falling(-0.07, 0.0070), 0.1), 0.1, 1e-12);
  EXPECT_EQ(blendLean(falling(-0.01, -0.0040), 0.1), 0.0) << "a crown is higher";
}

TEST(LiftOf, IsThatOfTheMiddleWhereTheLiftFallsOffWithTheSquareOfTheDistance) {
  // h (1 - d / b)^2 with h = 3 mm, b = 54 mm, seen from 15 to 54 mm
  constexpr double h = 0.003, b = 0.054, middle = 0.035;
  const auto lift = [&](double d) { return h * (1.0 - d / b) * (1.0 - d / b); };
  const double seen = (lift(0.054) - lift(0.015)) / 0.039;
  EXPECT_NEAR(liftOf(seen, 0.0, 0.05) * middle, lift(middle), 0.15 * lift(middle));
  EXPECT_EQ(liftOf(seen, 0.0, 0.0), 0.0);
  EXPECT_EQ(liftOf(kUnknown, 0.0, 0.05), 0.0);
  EXPECT_EQ(liftOf(0.02, kUnknown, 0.05), 0.0);
}

TEST(BlendedSlope, IsWhatIsSeenBeyondTheLipsOwnAndNoMoreThanBeamsCan) {
  const auto feigned = [](double seen, double sigma, double lean) {
    return blendedSlope({seen, sigma, 1.0}, 0.01, lean);
  };
  EXPECT_NEAR(feigned(-0.03, 0.0, 0.1).value, -0.04, 1e-12);
  EXPECT_NEAR(feigned(-0.03, 0.0, 0.02).value, -0.02, 1e-12);
  EXPECT_EQ(feigned(0.03, 0.0, 0.1).value, 0.0);  // they feign no lip that rises outwards
  EXPECT_EQ(feigned(-0.03, 0.0, 0.0).value, 0.0);
  // seen no better than beams can feign: half of it, with the error of both
  EXPECT_NEAR(feigned(-0.03, 0.05, 0.05).value, -0.02, 1e-12);
  EXPECT_NEAR(feigned(-0.03, 0.05, 0.05).sigma, 0.05 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(feigned(kUnknown, 0.05, 0.05).sigma, 0.0);
  EXPECT_EQ(blendedSlope({-0.03, 0.01, 1.0}, kUnknown, 0.05).value, 0.0);
}

}  // namespace tank_datum::beam_lean_test
