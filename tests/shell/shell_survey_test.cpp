#include "tank_datum/shell/shell_survey.h"

#include <gtest/gtest.h>

#include "core/portable_math.h"
#include "support/made_shells.h"
#include "support/refused.h"

namespace tank_datum::shell_survey_test {

using namespace made_shells;

/// Out of round by an oval that grows upwards, leaning by 1 in 250 towards 60 degrees, 2.5 mm of noise.
MadeShell outOfRound() {
  MadeShell shell;
  shell.noise = 0.0025;
  shell.count = 900'000;
  shell.radius = [](double a, double h) {
    return kRadius + 0.010 * (1.0 + 0.2 * h) * std::cos(2 * a) + 0.004 * h * std::cos(a - kTurn / 6);
  };
  return shell;
}

const ShellSurvey& surveyed() {
  static const ShellSurvey survey = surveyOf(outOfRound().points());
  return survey;
}

TEST(SurveyShell, RoundnessIsWithinThreeTenthsOfAMillimetre) {
  ASSERT_EQ(surveyed().roundness.size(), 5U);
  for (const Roundness& r : surveyed().roundness) {
    EXPECT_NEAR(r.max_deviation, 0.010 * (1.0 + 0.2 * r.height), 3e-4) << r.height;
    EXPECT_NEAR(r.min_deviation, -0.010 * (1.0 + 0.2 * r.height), 3e-4) << r.height;
    EXPECT_LT(r.sigma, 2e-4);
    EXPECT_NEAR(r.circle.radius, kRadius, 1e-4);
  }
}

TEST(SurveyShell, PlumbnessIsWithinFivePercent) {
  EXPECT_NEAR(surveyed().lean.offset(), 0.016, 0.05 * 0.016);
  EXPECT_NEAR(degrees(surveyed().lean.direction), 60.0, 2.0);
  ASSERT_EQ(surveyed().plumbness.size(), 360U);
  double largest = 0;
  for (double a = 0; a < kTurn; a += 0.001) {
    const MadeShell shell = outOfRound();
    largest = std::max(largest, std::abs(shell.radius(a, 4.3) - shell.radius(a, 0.3)));
  }
  ASSERT_NE(surveyed().worstPlumbness(), nullptr);
  EXPECT_NEAR(std::abs(surveyed().worstPlumbness()->offset), largest, 0.05 * largest);
}

TEST(SurveyShell, PointsAreByHeightThenByStation) {
  ASSERT_EQ(surveyed().points.size(), 5U * 360U);
  const ShellPoint& p = surveyed().points[2 * 360 + 45];
  EXPECT_NEAR(degrees(p.azimuth), 45.0, 1e-9);
  EXPECT_DOUBLE_EQ(p.height, 2.3);
  const MadeShell shell = outOfRound();
  EXPECT_NEAR(p.radius, shell.radius(kTurn / 8, 2.3), 5.0 * p.sigma);
  EXPECT_NEAR(p.offset, shell.radius(kTurn / 8, 2.3) - shell.radius(kTurn / 8, 0.3), 8.0 * p.sigma);
  EXPECT_NEAR(p.deviation, 0.010 * 1.46 * std::cos(kTurn / 4), 5.0 * p.sigma);
  EXPECT_GT(p.points, 40U);
}

TEST(SurveyShell, WorstPlacesAreFound) {
  const ShellSurvey& survey = surveyed();
  ASSERT_NE(survey.foot(), nullptr);
  EXPECT_EQ(survey.foot()->height, 0.3);
  ASSERT_NE(survey.worstAbove(), nullptr);
  EXPECT_DOUBLE_EQ(survey.worstAbove()->height, 4.3);
  EXPECT_EQ(ShellSurvey().foot(), nullptr);
  EXPECT_EQ(ShellSurvey().worstAbove(), nullptr);
  EXPECT_EQ(ShellSurvey().worstPlumbness(), nullptr);
}

TEST(SurveyShell, AnUnsureOffsetIsNotTheWorst) {
  ShellSurvey survey;
  survey.plumbness.resize(2);
  survey.plumbness[0].offset = -0.030, survey.plumbness[0].sigma = 0.0002;
  survey.plumbness[1].offset = 0.035, survey.plumbness[1].sigma = 0.005;
  EXPECT_EQ(survey.worstPlumbness(), &survey.plumbness[0]);
}

TEST(SurveyShell, HeightsAreAnOption) {
  ShellOptions options = everyMetre();
  options.heights = {0.25, 1.0, 4.0};
  const ShellSurvey survey = surveyOf(outOfRound().points(), options);
  ASSERT_EQ(survey.roundness.size(), 3U);
  EXPECT_EQ(survey.roundness[1].height, 1.0);
  EXPECT_NEAR(survey.roundness[1].max_deviation, 0.012, 3e-4);
  EXPECT_DOUBLE_EQ(survey.plumbness[0].height, 3.75);
}

TEST(SurveyShell, FewerPointsPerCellAreWorse) {
  ShellOptions options = everyMetre();
  options.cell_points = 50;
  const ShellSurvey few = surveyOf(outOfRound().points(), options);
  ASSERT_EQ(few.points.size(), surveyed().points.size());
  EXPECT_LT(few.points[100].points, surveyed().points[100].points);
}

TEST(SurveyShell, TheBandIsAnOption) {
  ShellOptions options = everyMetre();
  options.half_band = 0.05;
  const ShellSurvey narrow = surveyOf(outOfRound().points(), options);
  EXPECT_GT(narrow.points[100].sigma, surveyed().points[100].sigma);
}

TEST(SurveyShell, TheReachIsAnOption) {
  MadeShell bulged = outOfRound();
  bulged.noise = 0.001;
  bulged.radius = [](double a, double) { return kRadius + 0.2 * std::cos(2 * a); };
  ShellOptions options = everyMetre();
  EXPECT_EQ(surveyOf(bulged.points(), options).points.size(), 5U * 360U);
  options.reach = 0.1;
  EXPECT_LT(surveyOf(bulged.points(), options).points.size(), 3U * 360U);
}

TEST(SurveyShell, PartlyScannedHeightsAreUsedAsFarAsTheyGo) {
  MadeShell shell = outOfRound();
  shell.seen = [](double a, double h) { return h < 1.5 || a < 2.0; };
  const ShellSurvey survey = surveyOf(shell.points());
  EXPECT_EQ(survey.roundness.size(), 2U);  // higher up too little of the tank is seen for a circle
  ASSERT_EQ(survey.plumbness.size(), 360U);
  EXPECT_DOUBLE_EQ(survey.plumbness[50].height, 4.0);
  EXPECT_DOUBLE_EQ(survey.plumbness[200].height, 1.0);
  const ShellPoint& top = survey.points.back();
  EXPECT_DOUBLE_EQ(top.height, 4.3);
  EXPECT_TRUE(std::isnan(top.deviation));
  EXPECT_NEAR(top.radius, shell.radius(top.azimuth, 4.3), 5.0 * top.sigma);
}

TEST(SurveyShell, AHeightSeenOnAnArcIsComparedWithTheNearestCircle) {
  MadeShell shell;
  shell.noise = 0.001;
  const auto bulge = [](double a, double h) { return h > 3.0 ? 0.08 * std::exp(-square((a - 1.0) / 0.1)) : 0.0; };
  shell.radius = [&](double a, double h) { return kRadius + 0.01 * h * std::cos(a - 1.0) + bulge(a, h); };
  shell.seen = [](double a, double h) { return h < 3.0 || a < 2.0; };
  const ShellSurvey survey = surveyOf(shell.points());
  EXPECT_EQ(survey.roundness.size(), 3U);
  ASSERT_EQ(survey.arcs.size(), 2U);
  EXPECT_DOUBLE_EQ(survey.arcs.back().height, 4.3);
  EXPECT_NEAR(survey.arcs.back().max_deviation, 0.08, 0.004);  // without the lean: 0.10
  EXPECT_NEAR(degrees(survey.arcs.back().azimuth), 57.3, 1.0);
  EXPECT_EQ(survey.worstAbove(), &survey.arcs[survey.arcs[0].largest() < survey.arcs[1].largest() ? 1 : 0]);
  EXPECT_GT(survey.arcs.back().widest_gap, 4.0 * kRadius);
}

TEST(SurveyShell, WhatSetupsAreOffByIsInSigma) {
  ShellSurvey survey;
  survey.roundness.resize(1), survey.arcs.resize(1), survey.plumbness.resize(1);
  survey.roundness[0].sigma = survey.arcs[0].sigma = 0.003;
  survey.plumbness[0].sigma = 0.003, survey.plumbness[0].height = 10.0;
  SetupSpread error;
  error.plan = 0.004, error.tilt = 0.0012;
  survey.lean.sigma = 0.0009;
  survey = withSetupErrors(survey, error, 2);
  EXPECT_NEAR(survey.roundness[0].sigma, 0.005, 1e-9);
  EXPECT_NEAR(survey.arcs[0].sigma, 0.005, 1e-9);
  EXPECT_NEAR(survey.plumbness[0].sigma, 0.013, 1e-9);
  EXPECT_NEAR(survey.lean.sigma, 0.0015, 1e-9);
  EXPECT_NEAR(withSetupErrors(survey, error, 8).lean.sigma, std::hypot(0.0015, 0.0006), 1e-9);
}

TEST(SurveyShell, APeakedWeldNarrowerThanAStationIsPartOfTheShell) {
  MadeShell shell;
  shell.noise = 0.001, shell.count *= 2;
  shell.radius = [](double a, double) {
    return kRadius + std::max(0.0, 0.04 - 0.3 * kRadius * std::abs(a - kTurn / 8));
  };
  const ShellSurvey survey = surveyOf(shell.points());
  ASSERT_EQ(survey.points.size(), 5U * 360U);
  EXPECT_GT(survey.foot()->max_deviation, 0.02);
  EXPECT_NEAR(degrees(survey.foot()->azimuth), 45.0, 1.1);
}

TEST(SurveyShell, OfNoShellSaysSo) {
  MadeShell stub;
  stub.to = 0.15;
  const ShellSurvey survey = surveyOf(stub.points());
  EXPECT_FALSE(survey.valid());
  EXPECT_EQ(survey.message, "the scan holds no shell 0.3 m or more above the datum");
  EXPECT_TRUE(survey.roundness.empty());
  EXPECT_FALSE(survey.lean.valid());
}

TEST(ShellOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(ShellOptions())), "");
  const auto refused = [](auto change) {
    ShellOptions options = everyMetre();
    change(options);
    return said(firstError(options));
  };
  EXPECT_EQ(refused([](auto& o) {
              o.heights = {0.5, 0.4};
            }),
            "heights, 0.4, expected > 0 and <= 100 m and above the one before");
  EXPECT_EQ(refused([](auto& o) { o.heights = {0.0}; }),
            "heights, 0, expected > 0 and <= 100 m and above the one before");
  EXPECT_EQ(refused([](auto& o) { o.heights = {1.0, INFINITY}; }).rfind("heights, inf, ", 0), 0U);
  EXPECT_EQ(refused([](auto& o) { o.step = 0.05; }), "height_step, 0.05, expected >= 0.1 m");
  EXPECT_EQ(refused([](auto& o) { o.step = NAN; }).rfind("height_step, nan, ", 0), 0U);
  EXPECT_EQ(refused([](auto& o) { o.half_band = 0.0; }), "shell.half_band, 0, expected > 0 m");
  EXPECT_EQ(refused([](auto& o) { o.reach = -1.0; }), "shell.reach, -1, expected > 0 m");
  EXPECT_EQ(refused([](auto& o) { o.cell_points = 49; }), "shell.cell_points, 49, expected >= 50");
}

}  // namespace tank_datum::shell_survey_test
