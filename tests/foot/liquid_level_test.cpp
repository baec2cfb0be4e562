#include "foot/liquid_level.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_feet.h"

namespace tank_datum::liquid_level_test {

using namespace made_feet;

/// A floor of a tank that has tilted and settled, with liquid in its lowest part.
struct Floor {
  double slope = 0.01, sigma = 5e-5, sigma_slope = 1e-4;
  double wave = 0.0;    // upon the liquid, three round the tank [m]
  double rise = 0.0;    // of the liquid across the tank, off level [m/m]
  double climb = 0.01;  // of the floor along the shell, at the middle of its height [m]
  double lower = 0.0;   // by so much the floor lies elsewhere, over ten stations [m]
  int from = 100, to = 200;
  bool inside = true;
};

struct Seen {
  double share = 0.0;
  std::size_t dropped = 0, liquid = 0;  // stations, of them upon the liquid
};

Seen look(const Floor& floor) {
  MadeFoot made;
  Foot& foot = made.foot();
  foot.inside = floor.inside;
  FootPass pass = levelPass(0.5 * foot.half_step, 0.3);
  pass.outliers.reasons.assign(360, Unmeasured::None);
  pass.outliers.own = pass.fits;
  const double middle = 0.5 * (floor.from + floor.to);
  for (int i = 0; i < 360; ++i) {
    const bool is_liquid = i >= floor.from && i < floor.to;
    const double off = (i - middle) * kDegree, shore = 0.5 * (floor.to - floor.from) * kDegree;
    FootFit& fit = pass.fits[static_cast<std::size_t>(i)];
    FootFit& own = pass.outliers.own[static_cast<std::size_t>(i)];
    fit.z = is_liquid ? floor.rise * kRadius * std::sin(off) + floor.wave * std::cos(3.0 * off)
                      : floor.climb * (std::cos(shore) - std::cos(off));
    if (i >= 300 && i < 310) fit.z -= floor.lower;
    fit.sigma = own.sigma = floor.sigma;
    own.slope = is_liquid ? 0.0 : floor.slope;
    own.sigma_slope = floor.sigma_slope;
  }
  const FootPass left = withoutLiquid(foot, pass);
  Seen seen{left.liquid, 0, 0};
  for (std::size_t i = 0; i < left.fits.size(); ++i) {
    const bool dropped = !left.fits[i].valid();
    EXPECT_EQ(dropped, left.outliers.reasons[i] == Unmeasured::OtherSurface);
    seen.dropped += dropped;
    seen.liquid += dropped && static_cast<int>(i) >= floor.from && static_cast<int>(i) < floor.to;
  }
  return seen;
}

TEST(WithoutLiquid, IsAFloorThatSlopesBesideOneLevel) {
  const Seen seen = look({});
  EXPECT_NEAR(seen.share, 100.0 / 360.0, 0.01);
  EXPECT_EQ(seen.liquid, 100U);
  EXPECT_LE(seen.dropped, 106U) << "those whose windows hold both, and no more";
}

TEST(WithoutLiquid, OutsideNoneIsLookedFor) {
  Floor floor;
  floor.inside = false;
  EXPECT_EQ(look(floor).dropped, 0U);
}

TEST(WithoutLiquid, AnArcOf40DegreesTells) {
  Floor floor;
  floor.from = 150;
  const auto found = [&](int degrees) {
    floor.to = floor.from + degrees;
    return look(floor).liquid > 0;
  };
  EXPECT_FALSE(found(34));
  EXPECT_TRUE(found(44));
}

TEST(WithoutLiquid, TheFloorSlopesByTenStandardErrors) {
  Floor floor;
  floor.slope = 9.0 * std::hypot(floor.sigma_slope, 5e-5);
  EXPECT_EQ(look(floor).dropped, 0U);
  floor.slope *= 11.0 / 9.0;
  EXPECT_GT(look(floor).dropped, 0U);
}

TEST(WithoutLiquid, OrTheFloorClimbsBesideTheLevelByMoreThanOneThatIsTilted) {
  Floor floor;
  floor.slope = 0.0, floor.sigma = 0.0002;
  EXPECT_EQ(look(floor).dropped, 0U);
  floor.climb = 0.02;
  EXPECT_EQ(look(floor).liquid, 100U);
}

TEST(WithoutLiquid, WhatLiesLowerElsewhereShowsThatItIsNone) {
  Floor floor;
  floor.lower = 0.05;
  EXPECT_EQ(look(floor).dropped, 0U);
}

TEST(WithoutLiquid, IsLevelOnTheWholeAndNotArcByArc) {
  Floor floor;
  floor.wave = 0.0005;
  EXPECT_GT(look(floor).liquid, 0U);
  floor.wave = 0.0008;
  EXPECT_EQ(look(floor).dropped, 0U);
}

TEST(WithoutLiquid, AScanIsOffLevelBySecondsOfArc) {
  Floor floor;
  floor.rise = 5e-5;
  EXPECT_EQ(look(floor).liquid, 100U);
  floor.rise = 1e-3;
  EXPECT_EQ(look(floor).dropped, 0U);
}

TEST(WithoutLiquid, AllRoundItIsToldAndKept) {
  Floor floor;
  floor.from = 0, floor.to = 360;
  const Seen seen = look(floor);
  EXPECT_EQ(seen.share, 1.0);
  EXPECT_EQ(seen.dropped, 0U);
  floor.sigma = 0.00027;
  EXPECT_EQ(look(floor).share, 1.0);
  floor.sigma = 0.00033;
  EXPECT_EQ(look(floor).share, 0.0) << "a floor would look so";
  EXPECT_EQ(look(floor).dropped, 0U);
}

}  // namespace tank_datum::liquid_level_test
