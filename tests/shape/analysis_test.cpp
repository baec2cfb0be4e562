#include "shape/analysis.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "shape/deformation.h"
#include "support/made_surveys.h"
#include "support/refused.h"
#include "tank_datum/limits/limits.h"

namespace tank_datum::analysis_test {

using namespace made_surveys;

/// R 30 m, H 16 m, 235 MPa, 206 GPa: 11 Y / (E H) = 7.843e-4 1/m.
AnalysisOptions sixtyMetreTank() {
  AnalysisOptions options;
  options.facts = {16.0, 235.0, 206000.0, "open", "ringwall"};
  return options;
}

constexpr double kLimit = 11.0 * 235.0 / 206000.0 / 16.0;

Analysis analysed(const std::vector<double>& z, double sigma, const AnalysisOptions& options) {
  auto stations = survey(z, 30.0, sigma);
  const Tilt tilt = takeTilt(stations, {0.0, 0.0}, {});
  const double spacing = kTwoPi * 30.0 / static_cast<double>(z.size());
  return analyse({stations, tilt, 30.0, {}, {}, widestLevelledGap(spacing)}, options);
}

const Check& named(const Analysis& analysis, const std::string& name) {
  return *std::find_if(analysis.checks.begin(), analysis.checks.end(), [&](const Check& c) { return c.name == name; });
}

/// A tank whose n = 3 wave bends it to `share` of the limit.
std::vector<double> bent(double share) {
  return wave(360, [share](double a) { return 0.02 * std::cos(a) + share * kLimit * 900 / 9 * std::cos(3 * a); });
}

/// The mean of the half that is seen is not the ring's: a tilt of 5.5 mm is 6.5 mm from that, which fails no limit
/// of 6.
TEST(Analyse, LevelOverTheCircumferenceIsAboutTheMeanOfWhatWasNotSeenToo) {
  std::vector<double> z = wave(360, [](double a) { return 0.0055 * std::cos(a); });
  for (std::size_t i = 30; i < 210; ++i) z[i] = kUnknown;
  AnalysisOptions options = sixtyMetreTank();
  options.facts.service = Service::New;
  const Check level = named(analysed(noisy(z, 0.0001, 5), 0.0001, options), "foundation level over the circumference");
  EXPECT_GT(level.value, 0.0062);
  EXPECT_LT(level.interval.low, 0.0055);
  EXPECT_GT(level.interval.high, 0.0054);
  EXPECT_EQ(level.verdict, Verdict::Undecided);
}

TEST(Analyse, TheCurvatureDecides) {
  const auto verdict = [](double share) {
    return named(analysed(noisy(bent(share), 0.001, 1), 0.001, sixtyMetreTank()),
                 "curvature by trigonometric regression")
        .verdict;
  };
  EXPECT_EQ(verdict(0.5), Verdict::Pass);
  EXPECT_EQ(verdict(2.0), Verdict::Fail);
}

TEST(Analyse, TheClassicRuleAtOneDegreeIsExplainedAndNotJudged) {
  AnalysisOptions options = sixtyMetreTank();
  options.classic_points = 360;
  const Check check = named(analysed(bent(0.5), 0.001, options), "out-of-plane settlement S_i");
  EXPECT_EQ(check.verdict, Verdict::NotApplicable);
  EXPECT_NE(check.note.find("judges noise"), std::string::npos);
  EXPECT_TRUE(std::isnan(check.value));
  EXPECT_EQ(named(analysed(bent(0.2), 1e-4, sixtyMetreTank()), "out-of-plane settlement S_i").verdict, Verdict::Pass);
}

TEST(Analyse, AWideGapLeavesTheShapeUndecided) {
  std::vector<double> z = bent(0.2);
  for (std::size_t i = 10; i < 30; ++i) z[i] = NAN;  // 11 m
  const Analysis analysis = analysed(z, 1e-4, sixtyMetreTank());
  EXPECT_EQ(named(analysis, "curvature by trigonometric regression").verdict, Verdict::Undecided);
  EXPECT_TRUE(std::any_of(analysis.notes.begin(), analysis.notes.end(),
                          [](const std::string& n) { return n.find("gap of 11.0 m") != std::string::npos; }));
  std::vector<double> narrow = bent(0.2);
  for (std::size_t i = 10; i < 20; ++i) narrow[i] = NAN;  // 5.8 m
  EXPECT_EQ(named(analysed(narrow, 1e-4, sixtyMetreTank()), "curvature by trigonometric regression").verdict,
            Verdict::Pass);
}

TEST(Analyse, OneWaveAtTwiceTheLimitFailsWhateverItsNumber) {
  for (const int n : {6, 7, 8, 12}) {
    const auto z = wave(360, [n](double a) { return 2.0 * kLimit * 900 / (n * n) * std::cos(n * a); });
    const Analysis analysis = analysed(noisy(z, 0.001, 7), 0.001, sixtyMetreTank());
    const Check& check = named(analysis, "curvature by trigonometric regression");
    EXPECT_NEAR(check.value / check.limit, 2.0, 0.25) << n;
    EXPECT_EQ(check.verdict, Verdict::Fail) << n;
  }
}

TEST(Analyse, TheTopsOvalityIsTheCurvatureTimesHalfOfDAndH) {
  // dR = (D H / 2) u'': a second wave of 20 mm bends by 4 x 0.020 / 900, times 30 x 16 m
  const auto z = wave(360, [](double a) { return 0.020 * std::cos(2.0 * a); });
  AnalysisOptions options = sixtyMetreTank();
  options.limits = parseLimits(
      "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation\n"
      "own,seal,rim seal's room,top_ovality,judge,0.03,,m,,,,verified,drawing 7\n",
      "own.csv");
  const Analysis analysis = analysed(z, 1e-5, options);
  const double expected = 30.0 * 16.0 * 4.0 * 0.020 / 900.0;
  EXPECT_NEAR(analysis.top_ovality.largest.value, expected, 1e-4 * expected);
  EXPECT_LE(analysis.top_ovality.interval.low, expected);
  EXPECT_GE(analysis.top_ovality.interval.high, 0.999 * expected);
  EXPECT_EQ(named(analysis, "rim seal's room").verdict, Verdict::Fail);
  options.facts.height = NAN;
  const Analysis without = analysed(z, 1e-5, options);
  EXPECT_TRUE(std::isnan(without.top_ovality.largest.value));
  EXPECT_NE(named(without, "rim seal's room").note.find("option height"), std::string::npos);
}

TEST(Analyse, DistortionIsBySecondDifferences) {  // STANDARDS 3: a first difference would be 1/379, and fail
  std::vector<double> z(30, 0.0);
  const double spacing = kTurn;  // between 30 points round 188.5 m
  z[10] = spacing / 379.0;
  z[9] = 2.0 * (spacing / 379.0 - spacing / 487.0);
  const Analysis analysis = analysed(z, 1e-5, sixtyMetreTank());
  EXPECT_NEAR(1.0 / named(analysis, "distortion between survey points (DeBeer)").value, 487.0, 2.0);
  EXPECT_EQ(named(analysis, "distortion between survey points (DeBeer)").verdict, Verdict::Pass);
  EXPECT_NEAR(1.0 / named(analysis, "height of neighbouring survey points").value, 379.0, 0.5);
}

TEST(Analyse, GreenwoodsTiltIsShownAndNotJudged) {
  const auto z = wave(36, [](double a) { return 30.0 * 0.02 * std::cos(a); });
  const Check check = named(analysed(z, 1e-4, sixtyMetreTank()), "planar tilt");
  EXPECT_EQ(check.code, "Greenwood");
  EXPECT_NEAR(check.limit, 0.005, 1e-12);
  EXPECT_EQ(check.verdict, Verdict::NotApplicable);
}

TEST(Analyse, EveryReportSaysWhatItIsNot) {
  const Analysis analysis = analysed(bent(0.5), 0.001, sixtyMetreTank());
  const auto says = [&](const char* words) {
    return std::any_of(analysis.notes.begin(), analysis.notes.end(),
                       [&](const std::string& n) { return n.find(words) != std::string::npos; });
  };
  EXPECT_TRUE(says("not a code evaluation"));
  EXPECT_TRUE(says("levels of the instrument"));
  EXPECT_FALSE(says("no standard errors"));
  auto levelled = survey(bent(0.5), 30.0);
  const Analysis plain = analyse({levelled, takeTilt(levelled, {0.0, 0.0}, {}), 30.0}, sixtyMetreTank());
  EXPECT_TRUE(std::any_of(plain.notes.begin(), plain.notes.end(), [](const std::string& n) {
    return n.find("no standard errors: what they scatter by") != std::string::npos;
  }));
}

TEST(Analyse, JudgesTheFoundationByItsKind) {
  std::vector<double> z(360, 0.0);
  for (std::size_t i = 0; i < 8; ++i) z[i] = 0.010;
  AnalysisOptions ring = sixtyMetreTank(), earth = sixtyMetreTank();
  EXPECT_EQ(named(analysed(z, 1e-4, ring), "foundation level within 9 m").role, "for comparison") << "in service";
  ring.facts.service = earth.facts.service = Service::New;
  earth.facts.foundation = "earth";
  const Analysis on_ring = analysed(z, 1e-4, ring), on_earth = analysed(z, 1e-4, earth);
  EXPECT_EQ(named(on_ring, "foundation level within 9 m").verdict, Verdict::Fail);
  EXPECT_EQ(named(on_ring, "foundation level over the circumference").limit, 0.006);
  EXPECT_EQ(named(on_earth, "foundation level over the circumference").verdict, Verdict::Pass);
  EXPECT_EQ(named(on_earth, "foundation level within 9 m").verdict, Verdict::NotApplicable);
  ring.facts.foundation.clear();
  EXPECT_EQ(named(analysed(z, 1e-4, ring), "foundation level within 9 m").verdict, Verdict::NotEvaluated);
}

TEST(Analyse, ShellFiguresGoToTheLimitsToo) {
  auto stations = survey(bent(0.1), 30.0, 1e-4);
  Measure shell;
  shell.quantity = "roundness_foot";
  shell.worst = {0.020, 0.0005, 0.0};
  AnalysisOptions options = sixtyMetreTank();
  options.facts.service = Service::New;
  const Analysis analysis = analyse({stations, takeTilt(stations, {0, 0}, {}), 30.0, {shell}}, options);
  EXPECT_EQ(named(analysis, "radius 0.3 m above the bottom weld").verdict, Verdict::Pass);
  EXPECT_EQ(named(analysis, "radius higher up").verdict, Verdict::NotApplicable);
}

TEST(AnalysisOptions, AreRefusedByName) {
  AnalysisOptions options;
  options.classic_points = -1;
  EXPECT_EQ(said(firstError(options)), "classic_points, -1, expected >= 0");
  options.facts.height = 0;
  EXPECT_EQ(said(firstError(options)), "height, 0, expected > 0 and <= 100 m");
}

}  // namespace tank_datum::analysis_test
