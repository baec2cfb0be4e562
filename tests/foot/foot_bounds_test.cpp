#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>

#include "foot/foot_candidates.h"
#include "foot/foot_check.h"
#include "foot/station_section.h"
#include "support/made_feet.h"

namespace tank_datum::foot_bounds_test {

using namespace made_feet;

FootFit fitAt(double z, double sigma) {
  FootFit fit;
  fit.z = z, fit.sigma = sigma, fit.slope = 0.0, fit.sigma_slope = 0.001, fit.noise = 0.0005, fit.points = 100;
  fit.along = fit.bend = 0.0;
  return fit;
}

TEST(FindSteps, AStepOfTwoMillimetresIsNoneHoweverSureTheStations) {
  const auto dropped = [](double step) {
    std::vector<FootFit> fits(360, fitAt(0.0, 1e-7));
    for (std::size_t i = 100; i < 130; ++i) fits[i].z = step;
    const std::vector<bool> gone = findSteps(fits, 0.001, [](const StepRun&) { return false; }).dropped;
    return std::count(gone.begin(), gone.end(), true);
  };
  EXPECT_EQ(dropped(0.0018), 0);
  EXPECT_EQ(dropped(0.0023), 30);
}

TEST(CommonSigma, IsToldByTwentyDifferences) {
  std::vector<FootFit> fits;
  for (int i = 0; i < 10; ++i) fits.push_back(fitAt(i % 3 == 0 ? 0.002 : 0.0, 0.0002));  // ten of either lag
  EXPECT_GT(commonSigma(fits, 1), 0.0005);
}

TEST(FitFoundation, ADatumMayRunOneInAHundredAlongTheShell) {
  FootProfile pad;
  pad.band_from = 0.015, pad.band_to = pad.edge = 0.3, pad.blur = 0.006, pad.noise = 1e-5;
  FootPrior prior;
  prior.sigma_slope = 1e-4, prior.sigma_bend = 1e-6;
  std::vector<FootPoint> beside;
  for (int i = 0; i < 200; ++i) beside.push_back({0.2, 0.02 + 0.0013 * i, 0.0});
  EXPECT_NEAR(fitFoundation(beside, pad, 0.0, prior).sigma, 0.01 * 0.2, 0.0001);
}

/// The section through so many points in each of a hundred bins of 3 mm, without noise.
template <typename Section>
FootProfile sectionOf(const Section& section, int thin_bin = -1, int thin = 0) {
  std::vector<FootPoint> points;
  for (int bin = 0; bin < 100; ++bin) {
    const int count = bin == thin_bin ? thin : 120;
    for (int i = 0; i < count; ++i) {
      const double d = 0.003 * (bin + (i + 0.5) / count);
      points.push_back({0.0, d, section(0.003 * (bin + 0.5))});
    }
  }
  return stackProfile({points}, {0.0}, kScales);
}

TEST(StackProfile, ABinIsSeenFromTenPointsOn) {
  const auto flat = [](double) { return 0.0; };
  EXPECT_TRUE(std::isfinite(sectionOf(flat, 40, 11).height[40]));
  EXPECT_TRUE(std::isnan(sectionOf(flat, 40, 9).height[40]));
}

TEST(StackProfile, AStepIsAMillimetreBesideAWideSurface) {
  EXPECT_NEAR(sectionOf([](double d) { return d < 0.15 ? 0.0 : -0.0008; }).edge, 0.3, 0.001);
  EXPECT_NEAR(sectionOf([](double d) { return d < 0.15 ? 0.0 : -0.0016; }).edge, 0.15, 0.004);
}

TEST(StackProfile, WhereNothingIsSeenOfMoreThanALipNothingIsKnownToReachTheShell) {
  const auto seen_from = [](double nearest) {
    std::vector<FootPoint> points;
    for (int i = 0; i < 15000; ++i) {
      const double d = 0.3 * (i + 0.5) / 15000;
      const bool stray = d > 0.02 && d < 0.023;
      if (d > nearest || stray) points.push_back({0.0, d, 1e-4 * std::sin(i)});
    }
    return stackProfile({points}, {0.0}, kScales);
  };
  EXPECT_TRUE(seen_from(0.050).valid());  // 13 mm of the weld and 45 mm, 0.15 of the reach
  EXPECT_EQ(seen_from(0.050).unseen, 0.0);
  EXPECT_FALSE(seen_from(0.065).valid());
  EXPECT_NEAR(seen_from(0.065).unseen, 0.065, 0.004);
}

TEST(StackProfile, ALipSteeperThanOneInTenIsDrawnSoByWhatLiesBesideIt) {
  const auto lip = [](double slope) {
    return sectionOf([slope](double d) { return d < 0.075 ? slope * d : slope * 0.075 - 0.012; }).slope;
  };
  EXPECT_NEAR(lip(-0.085), -0.085, 0.005);
  EXPECT_NEAR(lip(-0.12), 0.0, 0.005);
}

TEST(StackProfile, WhatComesDownOverManyBinsIsAPlateToo) {
  // over 40 mm: no step, but flat beside the shell and flat beyond
  const auto plate = [](double high) {
    return [high](double d) { return high * std::min(1.0, std::max(0.0, (0.1 - d) / 0.04)); };
  };
  EXPECT_LT(sectionOf(plate(0.006)).band_to, 0.105);
  EXPECT_NEAR(sectionOf(plate(0.006)).offset, 0.006, 0.0025);  // the ramp leans it
  EXPECT_NEAR(sectionOf(plate(0.002)).edge, 0.3, 0.001);
}

TEST(StackProfile, WhereNoneIsSeenASurfaceMayGoOn) {
  const auto row = [](double d) { return d < 0.06 ? 0.0 : -0.01; };
  std::vector<FootPoint> points;
  for (int bin = 0; bin < 100; ++bin) {
    for (int i = 0; i < 150 && (bin < 5 || bin > 9) && (bin < 15 || bin > 18); ++i) {
      points.push_back({0.0, 0.003 * (bin + (i + 0.5) / 150), row(0.003 * (bin + 0.5))});
    }
  }
  const FootProfile profile = stackProfile({points}, {0.0}, kScales);
  EXPECT_NEAR(profile.edge, 0.06, 0.004) << "where the ringwall is first seen";
  EXPECT_NEAR(profile.band_from, 0.015, 0.004) << "beyond the weld, though it is seen from 30 mm on";
}

TEST(ProfileOf, PointsThirtyMillimetresOffTheFoundationAreSomethingElse) {
  const auto kept = [](double off) {
    MadeFoot made;
    for (int i = 0; i < 20; ++i) made.add(0.0, 0.15 + 0.001 * i, i % 2 == 0 ? 0.0 : off);
    return profileOf(made.foot().ring, {0.0, 0.004, 0.0, kReach, {0.25, 1.0}}, fitAt(0.0, 0.0001), {}, 3).points.size();
  };
  EXPECT_EQ(kept(0.027), 1U) << "one of a kind";
  EXPECT_EQ(kept(0.033), 2U);
}

/// The outliers of stations that are all fitted at 0 on one level section; one may have no shell.
std::vector<Unmeasured> outliersOfLevelRing(MadeFoot& made, std::optional<std::size_t> without_shell = {}) {
  Foot& foot = made.foot();
  if (without_shell) foot.shell_seen[*without_shell] = false;
  foot.points.resize(360);
  FootPass pass;
  pass.stood.assign(360, true);
  FootFit fit = fitAt(0.0, 0.0002);
  fit.noise = 0.0004, fit.half_width = foot.half_step;
  pass.fits.assign(360, fit);
  pass.sections.stations = 360;
  FootProfile& whole = pass.sections.whole;
  whole.bin = 0.003, whole.band_from = 0.015, whole.noise = 0.0005, whole.band_to = whole.edge = 0.3;
  pass.priors.slope.assign(360, 0.0);
  pass.priors.sigma_slope.assign(360, 0.003);
  return findOutliers(foot, pass).reasons;
}

/// Whether a station without a point of its own, between others of so many, is taken for something else.
bool isOutlier(int count) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s != 50) made.addStation(s, count, 0.02, 0.28, [](double) { return 0.0; });
  }
  return outliersOfLevelRing(made)[50] != Unmeasured::None;
}

/// The outliers of a level ring on which the shell is seen so far below so many stations, from the fiftieth on, by so
/// many points at each.
std::vector<Unmeasured> outliersWithShellBelow(double below, int count, int stations) {
  MadeFoot made;
  made.addAll(40, 0.02, 0.28, [](double) { return 0.0; });
  for (int s = 50; s < 50 + stations; ++s) {
    for (int i = 0; i < 12; ++i) made.add((s + 0.1) * made.step(), 0.0, 0.003 + 0.0015 * i);
    for (int i = 0; i < count; ++i) made.add((s - 0.2 + 0.05 * i) * made.step(), 0.0, -below);
  }
  return outliersOfLevelRing(made);
}

TEST(FindOutliers, TellsWhyAStationDoesNotStand) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s < 49 || s > 51) made.addStation(s, 40, 0.02, 0.28, [](double) { return 0.0; });
  }
  const std::vector<Unmeasured> reasons = outliersOfLevelRing(made, 100);
  EXPECT_EQ(reasons[10], Unmeasured::None);
  EXPECT_EQ(reasons[50], Unmeasured::Hidden);
  EXPECT_EQ(reasons[100], Unmeasured::NoShell);
  EXPECT_EQ(outliersWithShellBelow(0.010, 5, 1)[50], Unmeasured::OtherSurface);
}

bool goesOnBelow(double below, int count) {
  return outliersWithShellBelow(below, count, 1)[50] == Unmeasured::OtherSurface;
}

TEST(FindOutliers, WhereTheShellGoesOnBelowAThirdOfTheStationsNoneStandsOnTheSurface) {
  const auto dropped = [](int stations) {
    const std::vector<Unmeasured> outliers = outliersWithShellBelow(0.010, 5, stations);
    return std::count(outliers.begin(), outliers.end(), Unmeasured::OtherSurface);
  };
  EXPECT_EQ(dropped(115), 115);
  EXPECT_EQ(dropped(125), 360);
}

TEST(FindOutliers, AShellSeenFurtherDownThanAStationShowsAKerbThatStandsBeforeIt) {
  EXPECT_TRUE(goesOnBelow(0.010, 5));
  EXPECT_FALSE(goesOnBelow(0.010, 3)) << "three are stray";
  EXPECT_TRUE(goesOnBelow(0.010, 4));
  EXPECT_FALSE(goesOnBelow(0.0020, 5)) << "1 mm and three standard deviations are errors";
  EXPECT_TRUE(goesOnBelow(0.0030, 5));
  EXPECT_TRUE(goesOnBelow(0.0200, 5));
  EXPECT_FALSE(goesOnBelow(0.0260, 5)) << "a twenty-fifth of the section's reach lower is something else";
}

TEST(FindOutliers, WhereStationsHaveTwentyPointsOneWithoutAnyIsNotMeasured) {
  EXPECT_FALSE(isOutlier(16));
  EXPECT_TRUE(isOutlier(24));
}

TEST(StackProfile, APlateUpToThreeCentimetresThickLiesOnTheRingwallBesideIt) {
  const auto slopeOf = [](double step) {  // in steps of the ringwall's slope, which the plate has not
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<FootPoint> points;
    for (int i = 0; i < 24'000; ++i) {
      const double d = 0.3 * (i + 0.5) / 24'000.0;
      points.push_back({0.0, d, (d < 0.065 ? 0.0 : -step - 0.004 * d) + 0.0005 * normal(random)});
    }
    return stackProfile({points}, {0.0}, kScales).slope / -0.004;
  };
  EXPECT_NEAR(slopeOf(0.025), 1.0, 0.25);
  EXPECT_NEAR(slopeOf(0.035), 0.0, 0.25);
}

}  // namespace tank_datum::foot_bounds_test
