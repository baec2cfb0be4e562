#include "setups/gross_shifts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/made_overlaps.h"

namespace tank_datum::gross_shifts_test {

using namespace made_overlaps;

constexpr double kReach = 0.5;

/// A survey of six setups of which one is far off, each compared within a scope's window only.
struct GrossSurvey {
  Recipe recipe;
  Survey survey;
  int looks = 0;        ///< how often arcs were looked for
  double layer = 0.0;   ///< what the third setup sees upon the foundation, of others unseen [m]
  double layer_to = 0;  ///< up to this azimuth [rad]
  double rough = 0.0;   ///< what it lies above and below its surface in turn [m]
  double astray = 0.0;  ///< what it is off by when it is looked for far off only [m]

  explicit GrossSurvey(const SetupMotion& of_third) {
    recipe.half_view = 80.0 * kDegree;
    recipe.sigma_error = recipe.sigma_plan = 0.0005, recipe.sigma_tilt = 1e-6;
    std::mt19937_64 random(2);
    survey = made(recipe, random);
    survey.errors.segment<5>(10) = of_third.vector();
    look(recipe, survey, random);
  }

  /// How far off one of the setups of an arc is, by what it sees on top of its own error.
  double off(const ArcView& arc, std::size_t setup, const ViewScope& scope) const {
    if (setup != 2 || arc.shell) return 0.0;
    return (arc.azimuth < layer_to ? layer : 0.0) + (arc.number % 2 == 0 ? rough : -rough) +
           (scope.window > ViewScope().window ? astray : 0.0);
  }

  /// The arc without the setups that lie outside of the window about the others.
  ArcView within(const ArcView& arc, const ViewScope& scope) const {
    ArcView kept = arc;
    for (Eigen::Index i = 0; i < arc.motion.rows(); ++i)
      kept.seen.offsets[i] += off(arc, arc.seen.setups[static_cast<std::size_t>(i)], scope);
    kept.seen.setups.clear();
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < arc.motion.rows(); ++i) {
      const std::size_t setup = arc.seen.setups[static_cast<std::size_t>(i)];
      SetupMotion::Vector error = survey.errors.segment<5>(5 * static_cast<Eigen::Index>(setup));
      if (!scope.shifts.empty()) error -= scope.shifts[setup].vector();
      if (std::abs(arc.motion.row(i).dot(error) + off(arc, setup, scope)) > scope.window * kReach) continue;
      kept.seen.setups.push_back(setup);
      rows.push_back(i);
    }
    kept.motion = arc.motion(rows, Eigen::all);
    kept.seen.offsets = Eigen::VectorXd(kept.seen.offsets(rows));
    kept.seen.offsets.array() -= kept.seen.offsets.mean();
    const auto count = static_cast<Eigen::Index>(rows.size());
    kept.seen.information = (Eigen::MatrixXd::Identity(count, count) -
                             Eigen::MatrixXd::Constant(count, count, 1.0 / static_cast<double>(count))) /
                            (recipe.sigma_arc * recipe.sigma_arc);
    return kept;
  }

  std::vector<ArcView> viewed() {
    const auto view = [this](const ViewScope& scope) {
      ++looks;
      std::vector<ArcView> views;
      for (const ArcView& arc : survey.arcs) {
        ArcView kept = within(arc, scope);
        if (kept.seen.setups.size() > 1) views.push_back(std::move(kept));
      }
      return views;
    };
    return viewWithGrossShifts(view, recipe.setups, kReach, {});
  }

  SetupAdjustment adjusted() { return adjustSetups(viewed(), recipe.setups, {}); }
};

TEST(GrossShifts, ASetupFarOffInHeightOrInPlanIsComparedAndBad) {
  for (const double dz : {-0.050, 0.045, 0.150}) {
    const SetupAdjustment adjusted = GrossSurvey({dz, 0.0, 0.0, 0.0, 0.0}).adjusted();
    EXPECT_NEAR(adjusted.errors[10], dz, 0.001) << dz;
    EXPECT_TRUE(adjusted.bad[2]) << dz;
  }
  const SetupAdjustment adjusted = GrossSurvey({0.0, 0.0, 0.0, 0.030, -0.060}).adjusted();
  EXPECT_NEAR(adjusted.errors[13], 0.030, 0.002);
  EXPECT_NEAR(adjusted.errors[14], -0.060, 0.002);
  EXPECT_TRUE(adjusted.bad[2]);
}

TEST(GrossShifts, AreLookedForFiveTimesAsFarOff) {
  EXPECT_NEAR(GrossSurvey({0.190, 0.0, 0.0, 0.0, 0.0}).adjusted().errors[10], 0.190, 0.001);
  EXPECT_NEAR(GrossSurvey({0.230, 0.0, 0.0, 0.0, 0.0}).adjusted().errors[10], 0.0, 0.005);
}

TEST(GrossShifts, AreLargerThanHalfOfTheUsualWindow) {
  const auto looks = [](const SetupMotion& error) {
    GrossSurvey survey(error);
    survey.viewed();
    return survey.looks;
  };
  EXPECT_EQ(looks({0.015, 0.0, 0.0, 0.0, 0.0}), 2);
  EXPECT_GT(looks({0.035, 0.0, 0.0, 0.0, 0.0}), 2);
  EXPECT_EQ(looks({0.0, 0.0, 0.0, 0.011, 0.011}), 2);
  EXPECT_GT(looks({0.0, 0.0, 0.0, 0.024, 0.024}), 2);
}

TEST(GrossShifts, AreNoneOfASetupThatSeesALayerOnAPartOfItsArcs) {
  // 60 mm high from where its view begins, at 40 degrees, on so much of it, which ends at 200
  const auto errorFor = [](double share) {
    GrossSurvey survey({});
    survey.layer = 0.060, survey.layer_to = (40.0 + share * 160.0) * kDegree;
    return survey.adjusted().errors[10];
  };
  EXPECT_NEAR(errorFor(0.75), 0.0, 0.005);    // three times as many arcs as without
  EXPECT_NEAR(errorFor(0.86), 0.060, 0.010);  // six times
}

TEST(GrossShifts, AreOfSetupsThatAreLevel) {
  const auto errorFor = [](double arc_seconds) {
    return GrossSurvey({0.060, toRadians(arc_seconds / 3600.0), 0.0, 0.0, 0.0}).adjusted().errors[10];
  };
  EXPECT_NEAR(errorFor(45.0), 0.060, 0.002);
  EXPECT_NEAR(errorFor(80.0), 0.0, 0.005);
}

/// The error that is found of a third setup 60 mm too high, where something else is so, too.
double errorOfHigh(double GrossSurvey::*what, double value) {
  GrossSurvey survey({0.060, 0.0, 0.0, 0.0, 0.0});
  survey.*what = value;
  return survey.adjusted().errors[10];
}

TEST(GrossShifts, LeaveNoMoreThanThoseOfAll) {
  EXPECT_NEAR(errorOfHigh(&GrossSurvey::rough, 0.0012), 0.060, 0.002);
  EXPECT_NEAR(errorOfHigh(&GrossSurvey::rough, 0.0020), 0.0, 0.005);
}

TEST(GrossShifts, AreAsLargeWhereTheyAreLookedForAgain) {
  EXPECT_NEAR(errorOfHigh(&GrossSurvey::astray, 0.0075), 0.060, 0.002);
  EXPECT_NEAR(errorOfHigh(&GrossSurvey::astray, 0.0140), 0.0, 0.005);
}

TEST(GrossShifts, AreDroppedWhereTheyLetNoMoreArcsCompare) {
  // what the third setup sees is 60 mm too high where looked for far off, and nothing is there when looked for again
  const GrossSurvey far({0.060, 0.0, 0.0, 0.0, 0.0});
  const auto view = [&](const ViewScope& scope) {
    std::vector<ArcView> views;
    for (const ArcView& arc : far.survey.arcs) {
      ViewScope usual;
      ArcView kept = far.within(arc, scope.shifts.empty() ? scope : usual);
      if (kept.seen.setups.size() > 1) views.push_back(std::move(kept));
    }
    return views;
  };
  const std::vector<ArcView> views = viewWithGrossShifts(view, far.recipe.setups, kReach, {});
  EXPECT_NEAR(adjustSetups(views, far.recipe.setups, {}).errors[10], 0.0, 0.005);
}

}  // namespace tank_datum::gross_shifts_test
