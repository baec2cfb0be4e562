#include <gtest/gtest.h>

#include <algorithm>

#include "core/units.h"
#include "shape/analysis.h"
#include "shape/deformation.h"
#include "shape/level_rows.h"
#include "shape/out_of_plane.h"
#include "shape/survey_rows.h"
#include "support/made_analyses.h"

namespace tank_datum::analysis_bounds_test {

using namespace made_surveys;
constexpr double kFoot = 0.3048;

TEST(Analyse, AGapOfMoreThanTwentyFeetLeavesTheShapeUndecided) {
  for (const std::size_t missing : {2U, 3U}) {  // gaps of 4.7 and 6.3 m
    std::vector<double> z = level(120);
    for (std::size_t i = 0; i < missing; ++i) z[30 + i] = kUnknown;
    const Analysis analysis = analysed(z, 30.0, 0.001);
    EXPECT_EQ(notes(analysis, "A gap of"), missing > 2) << missing;
    const auto of_shape = [](const Measure& m) { return m.quantity == "curvature" || m.quantity == "antipodal"; };
    EXPECT_EQ(std::count_if(analysis.measures.begin(), analysis.measures.end(), of_shape), 2);
    for (const Measure& m : analysis.measures) {
      if (of_shape(m)) {
        EXPECT_EQ(m.whole_ring, missing == 2) << m.quantity << " " << missing;
      }
    }
  }
}

/// 32 ft, of a levelling whose points are more than 20 ft apart; one of them may not be missing.
TEST(Analyse, ASparseLevellingIsWholeUpToTheCodesOwnSpacing) {
  const auto whole = [](double spacing, bool all) {
    std::vector<double> z = level(16);
    if (!all) z[3] = kUnknown;
    const Analysis analysis = analysed(z, 16.0 * spacing * kFoot / kTwoPi, 0.001);
    return std::all_of(analysis.measures.begin(), analysis.measures.end(),
                       [](const Measure& m) { return m.whole_ring || m.quantity.find("tilt") == 0; });
  };
  EXPECT_TRUE(whole(21.0, true));
  EXPECT_TRUE(whole(31.9, true));
  EXPECT_FALSE(whole(32.1, true));
  EXPECT_FALSE(whole(21.0, false));
}

TEST(Analyse, AScanOfSoFewStationsIsNot) {  // what lies between them was measured and is in no figure
  const auto stations = survey(level(16), 16.0 * 21.0 * kFoot / kTwoPi, 0.001);
  const Analysis analysis =
      analyse({stations, fitTilt(stations, {0.0, 0.0}, {}), 16.0 * 21.0 * kFoot / kTwoPi}, AnalysisOptions());
  EXPECT_TRUE(notes(analysis, "Neighbouring elevations are up to 6.4 m apart: beyond 6.10 m (20 ft)"));
  EXPECT_EQ(std::count_if(analysis.checks.begin(), analysis.checks.end(),
                          [](const Check& c) { return c.verdict == Verdict::Pass && c.quantity != "tilt_slope"; }),
            0);
}

/// What was refused may be a heave: it passes no rule that the heave fails, and says no word on others.
TEST(Analyse, IntervalsHoldWhatWasRefusedAndMayBeTheDatum) {
  const auto analysis = [](double refused, StationFlag flag) {
    auto stations = survey(level(360), 10.0, 0.0002);
    for (std::size_t i = 100; i < 109; ++i) {
      const double share = 1.0 - std::abs(static_cast<double>(i) - 104.0) / 5.0;
      stations[i].flag = flag;
      stations[i].z_refused = share * refused;
      if (flag == StationFlag::Missing) stations[i].z = stations[i].u = kUnknown;
    }
    return analyse({stations, fitTilt(stations, {0.0, 0.0}, {}), 10.0}, AnalysisOptions());
  };
  const auto interval = [](const Analysis& found, const char* quantity) {
    return std::find_if(found.measures.begin(), found.measures.end(),
                        [&](const Measure& m) { return m.quantity == quantity; })
        ->interval;
  };
  for (const StationFlag flag : {StationFlag::Interpolated, StationFlag::Missing}) {
    const Analysis heave = analysis(0.020, flag), none = analysis(kUnknown, flag);
    EXPECT_LT(interval(none, "out_of_plane").high, 0.002);
    EXPECT_NEAR(interval(heave, "out_of_plane").high, 0.020, 0.001);
    EXPECT_NEAR(interval(analysis(-0.020, flag), "out_of_plane").high, 0.020, 0.001);
    EXPECT_LT(interval(heave, "out_of_plane").low, 0.001);
    // half of the range within 3 m
    EXPECT_NEAR(interval(heave, "level_3m").high, 0.010, 0.001);
    EXPECT_GT(interval(heave, "curvature").high, 3.0 * interval(none, "curvature").high);
    EXPECT_TRUE(notes(heave, "What was refused may be a heave of the foundation (stations: 9)"));
    EXPECT_FALSE(notes(none, "What was refused"));
  }
}

/// What a bridge may be off passes no rule either.
TEST(Analyse, IntervalsHoldTheErrorsOfBridges) {
  const auto high = [](double sigma) {
    auto stations = survey(level(360), 10.0, 0.0002);
    for (std::size_t i = 100; i < 109; ++i) stations[i].flag = StationFlag::Interpolated, stations[i].sigma_z = sigma;
    const Analysis found = analyse({stations, fitTilt(stations, {0.0, 0.0}, {}), 10.0}, AnalysisOptions());
    return std::find_if(found.measures.begin(), found.measures.end(),
                        [](const Measure& m) { return m.quantity == "out_of_plane"; })
        ->interval.high;
  };
  EXPECT_LT(high(0.0002), 0.002);
  // 97.5 % of |normal deviates| are below 2.24
  EXPECT_NEAR(high(0.005), 2.24 * 0.005, 0.0015);
}

/// Where the datum is known to lie lower than its neighbours say, nothing on the shape passes.
TEST(Analyse, WhereTheShellIsSeenBelowItsNeighboursNoRuleOnTheShapePasses) {
  const auto analysis = [](Unmeasured reason) {
    std::vector<double> z = level(360);
    z[100] = kUnknown;
    auto stations = survey(z, 10.0, 0.0002);
    stations[100].reason = reason;
    return analyse({stations, fitTilt(stations, {0.0, 0.0}, {}), 10.0}, AnalysisOptions());
  };
  const auto whole = [](const Analysis& found) {
    return std::any_of(found.measures.begin(), found.measures.end(),
                       [](const Measure& m) { return m.whole_ring && m.quantity == "out_of_plane"; });
  };
  EXPECT_TRUE(whole(analysis(Unmeasured::Hidden)));
  EXPECT_FALSE(whole(analysis(Unmeasured::ShellBelow)));
  EXPECT_FALSE(
      notes(analysis(Unmeasured::Hidden), "The shell is seen below the level that the neighbours give (stations: 1)"));
  EXPECT_TRUE(notes(analysis(Unmeasured::ShellBelow),
                    "The shell is seen below the level that the neighbours give (stations: 1)"));
}

/// What is interpolated between few measured stations is a part of the figures and of their intervals.
TEST(Analyse, InterpolatedStationsMoveNoInterval) {
  const auto interval = [](bool interpolated) {
    std::vector<double> z = wave(40, [](double a) { return 0.02 * std::cos(2.0 * a); });
    auto stations = survey(z, 10.0, 0.0002);
    for (const std::size_t i : {7U, 22U, 23U})
      if (interpolated) stations[i].flag = StationFlag::Interpolated;
    const Analysis analysis = analyse({stations, fitTilt(stations, {0.0, 0.0}, {}), 10.0}, AnalysisOptions());
    std::vector<Interval95> found;
    for (const Measure& m : analysis.measures) {
      if (m.quantity != "level_9m" && m.quantity != "out_of_plane" && m.quantity != "slope_10m") continue;
      EXPECT_LE(m.interval.low, m.worst.value) << m.quantity;
      EXPECT_GE(m.interval.high, 0.95 * m.worst.value) << m.quantity;
      found.push_back(m.interval);
    }
    return found;
  };
  const auto all = interval(false), some = interval(true);
  ASSERT_EQ(all.size(), 3U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(some[i].low, all[i].low, 0.03 * all[i].low) << i;
    EXPECT_NEAR(some[i].high, all[i].high, 0.03 * all[i].high) << i;
  }
}

TEST(Analyse, StationsThatScatterByHalfMoreThanTheySayAreTold) {
  for (const auto& [scatter, told] : {std::pair(1.2, false), {1.9, true}}) {
    const Analysis analysis = analysed(noisy(level(72), 0.001 * scatter, 3), 30.0, 0.001);
    EXPECT_EQ(notes(analysis, "times their standard errors"), told) << scatter;
  }
}

TEST(FitTilt, ADatumLevelToWithinANanometreHasNoVarianceToExplain) {
  const auto r2 = [](double scatter) {
    auto stations = survey(wave(8, [=](double a) { return scatter * std::cos(4.0 * a); }), 10.0, 0.001);
    return fitTilt(stations, {0.0, 0.0}, {}).r2;
  };
  EXPECT_TRUE(std::isnan(r2(0.8e-9)));
  EXPECT_TRUE(std::isfinite(r2(1.3e-9)));
}

TEST(FitOutOfPlane, NeedsMoreThanSixtyFourStationsAndEighteenMetresOfDiameter) {
  const auto message = [](std::size_t count, double radius) {
    auto stations = survey(level(count), radius, 0.001);
    return fitOutOfPlane(stations, radius).message;
  };
  EXPECT_EQ(message(72, 10.0), "");
  EXPECT_NE(message(64, 10.0), "");
  EXPECT_EQ(message(360, 9.35), "");
  EXPECT_NE(message(360, 9.25), "");
}

TEST(FitOutOfPlane, FourWavesAreFittedWhereHigherOnesSayNothing) {
  // what is left beside n = 2 is a wave far above those of a tank of 12 m radius, six
  auto stations =
      survey(wave(360, [](double a) { return 0.01 * std::cos(2 * a) + 0.0005 * std::cos(50 * a); }), 12.0, 0.0005);
  EXPECT_EQ(fitOutOfPlane(stations, 12.0).order, 4);
}

/// What is said of a survey of ten points so far apart.
std::string planned(double spacing) {
  const double radius = 10.0 * spacing / kTurn;
  return planSurvey(survey(level(360), radius), radius, 10).message;
}

TEST(PlanSurvey, AMicrometreBeyondTheRulesSpacingsIsRounding) {
  EXPECT_EQ(planned(15.0 * kFoot - 0.8e-6), "");
  EXPECT_NE(planned(15.0 * kFoot - 1.3e-6), "");
  EXPECT_EQ(planned(22.0 * kFoot + 0.8e-6), "");
  EXPECT_NE(planned(22.0 * kFoot + 1.3e-6), "");
}

TEST(PlanSurvey, StartsATenthOfAMicroradianApartAreOne) {
  const auto starts = [](double off) {  // of surveys of 36 points among 360 stations, those of every second point moved
    const double radius = 36.0 * 20.0 * kFoot / kTurn;
    auto stations = survey(level(360), radius);
    for (std::size_t i = 0; i < stations.size(); ++i) stations[i].azimuth += i / 10 % 2 == 1 ? off : 0.0;
    return planSurvey(stations, radius, 36).starts.size();
  };
  EXPECT_EQ(starts(0.7e-7), 10U);
  EXPECT_EQ(starts(1.4e-7), 20U);
}

TEST(SecondDifferenceRows, PointsTypedInMayBeThirtyTwoFeetApart) {
  const auto rows = [](double spacing) {
    const double radius = 72.0 * 5.0 / kTurn;  // 72 points 5 m apart, one of them put further on
    auto stations = survey(level(72), radius);
    stations[30].azimuth = stations[29].azimuth + spacing / radius;
    for (std::size_t i = 31; i < 34; ++i)
      stations[i].flag = StationFlag::Missing, stations[i].u = stations[i].z = kUnknown;
    const RingSeries u(stations, &Station::u, &Station::sigma_z);
    SurveyPlan plan;
    plan.points = 72, plan.spacing = 5.0, plan.as_they_are = true, plan.starts = {0.0};
    return secondDifferenceRows(u, plan, radius).size();
  };
  EXPECT_EQ(rows(9.6), rows(5.0));
  EXPECT_LT(rows(9.9), rows(5.0));
}

TEST(LevelWithin, StationsAMillionthFurtherApartThanTheArcAreWithinIt) {
  const auto most = [](double beyond) {
    std::vector<double> z(36, 0.0);
    for (std::size_t i = 0; i < z.size(); i += 2) z[i] = 1.0;
    const auto stations = survey(z, 10.0);
    const RingSeries series(stations, &Station::z, &Station::sigma_z);
    return LevelWithin(series, 10.0, kTurn * 10.0 / 36.0 / (1.0 + beyond)).largest(series.values()).value;
  };
  EXPECT_EQ(most(0.0), 0.5);
  EXPECT_EQ(most(0.8e-6), 0.5);
  EXPECT_LT(most(1.3e-6), 0.5);
}

}  // namespace tank_datum::analysis_bounds_test
