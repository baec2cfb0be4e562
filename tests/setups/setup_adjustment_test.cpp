#include "setups/setup_adjustment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/made_overlaps.h"

namespace tank_datum::setup_adjustment_test {

using namespace made_overlaps;

struct Tally {
  double rms = 0.0, out_of_plane = 0.0, within = 0.0, tilt_within = 0.0;
};

/// Root mean squares of 360 stations' errors after the adjustment, and how often they are within two of their sigmas.
Tally tallyOf(const Recipe& recipe, const SetupOptions& options, int surveys) {
  Tally tally;
  for (int seed = 1; seed <= surveys; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const Survey survey = made(recipe, random);
    const SetupAdjustment adjusted = adjustSetups(survey.arcs, recipe.setups, options);
    const Eigen::MatrixXd moves = derivatives(recipe, survey);
    const Eigen::VectorXd left = moves * (survey.errors - adjusted.errors);
    const Eigen::VectorXd sigma = (moves * adjusted.covariance * moves.transpose()).diagonal().cwiseSqrt();
    tally.rms += left.squaredNorm() / 360.0 / surveys;
    tally.out_of_plane += withoutPlane(left).squaredNorm() / 360.0 / surveys;
    tally.within += (left.cwiseAbs().array() <= 2.0 * sigma.array()).cast<double>().mean() / surveys;
  }
  tally.rms = std::sqrt(tally.rms);
  tally.out_of_plane = std::sqrt(tally.out_of_plane);
  return tally;
}

TEST(SetupAdjustment, WithoutNoiseEverythingButTheCommonPartIsFound) {
  Recipe recipe;
  recipe.sigma_arc = 1e-6;
  std::mt19937_64 random(5);
  const Survey survey = made(recipe, random);
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, recipe.setups, {});
  for (const ArcView& arc : survey.arcs) {
    Eigen::VectorXd left(static_cast<Eigen::Index>(arc.seen.setups.size()));
    for (std::size_t i = 0; i < arc.seen.setups.size(); ++i) {
      const auto at = 5 * static_cast<Eigen::Index>(arc.seen.setups[i]);
      left[static_cast<Eigen::Index>(i)] =
          arc.motion.row(static_cast<Eigen::Index>(i)).dot((survey.errors - adjusted.errors).segment<5>(at));
    }
    left.array() -= left.mean();
    EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-5);
  }
  EXPECT_GT(adjusted.all_before, 0.0005);
  EXPECT_LT(adjusted.all_after, 1e-5);
}

TEST(SetupAdjustment, SixSetupsOfTwoMillimetresReachWhatTheoryAllowsAndSaySo) {
  const Tally tally = tallyOf({}, {}, 30);
  EXPECT_LT(tally.out_of_plane, 0.00030);
  EXPECT_LT(tally.rms, 0.0013);
  EXPECT_GT(tally.rms, 0.0007);
  EXPECT_GT(tally.within, 0.88);
  EXPECT_LT(tally.within, 0.995);
}

TEST(SetupAdjustment, PerfectRegistrationCostsNothing) {
  Recipe recipe;
  recipe.sigma_error = recipe.sigma_plan = 1e-6;
  recipe.sigma_tilt = 1e-9;
  std::mt19937_64 random(3);
  const Survey survey = made(recipe, random);
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, recipe.setups, {});
  const Eigen::MatrixXd moves = derivatives(recipe, survey);
  EXPECT_TRUE(adjusted.height_estimated);
  EXPECT_LT((moves * adjusted.covariance * moves.transpose()).diagonal().cwiseSqrt().maxCoeff(), 0.00015);
  EXPECT_LT((moves * adjusted.errors).cwiseAbs().maxCoeff(), 0.00010);
}

TEST(SetupAdjustment, VarianceComponentsFollowTheErrors) {
  Recipe recipe;
  recipe.setups = 24;
  recipe.sigma_error = 0.005;
  recipe.sigma_tilt = 40.0 / 3600.0 * kPi / 180.0;
  recipe.sigma_plan = 0.001;
  std::mt19937_64 random(11);
  const SetupAdjustment adjusted = adjustSetups(made(recipe, random).arcs, recipe.setups, {});
  EXPECT_NEAR(adjusted.spread.height, recipe.sigma_error, 0.35 * recipe.sigma_error);
  EXPECT_NEAR(adjusted.spread.tilt, recipe.sigma_tilt, 0.35 * recipe.sigma_tilt);
  EXPECT_NEAR(adjusted.spread.plan, recipe.sigma_plan, 0.35 * recipe.sigma_plan);
}

TEST(SetupAdjustment, GivenSigmasAreTaken) {
  std::mt19937_64 random(2);
  const Survey survey = made({}, random);
  SetupOptions options;
  options.error = 0.004;
  options.tilt = 1e-4;
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, 6, options);
  EXPECT_EQ(adjusted.spread.height, 0.004);
  EXPECT_EQ(adjusted.spread.tilt, 1e-4);
  EXPECT_EQ(adjusted.spread.plan, 0.004);
  EXPECT_FALSE(adjusted.height_estimated);
  // what all six share stays unknown: a sixth of the variance of one, the tilts' part on top
  EXPECT_GT(std::sqrt(adjusted.covariance(0, 0)), 0.004 / std::sqrt(6.0));
}

/// What is taken where nothing tells: usual values that are uncertain themselves.
constexpr double kAssumedHeight = 0.002 * 1.2909944487, kAssumedTilt = 10.0 / 3600.0 * kDegree * 1.2909944487;

TEST(SetupAdjustment, TwoSetupsTakeTheUsualSigmas) {
  Recipe recipe;
  recipe.setups = 2;
  recipe.half_view = 100.0 * kPi / 180.0;
  std::mt19937_64 random(2);
  Survey survey = made(recipe, random);
  survey.arcs.resize(6);  // one overlap
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, 2, {});
  EXPECT_FALSE(adjusted.height_estimated);
  EXPECT_NEAR(adjusted.spread.height, kAssumedHeight, 1e-11);
}

/// What is made of setups that overlap by one arc each, whose heights err by so much.
SetupAdjustment ofShortOverlaps(double sigma_error) {
  Recipe recipe;
  recipe.setups = 12;
  recipe.sigma_error = sigma_error, recipe.sigma_tilt = 1e-9;
  recipe.half_view = 17.0 * kDegree;
  std::mt19937_64 random(4);
  const Survey survey = made(recipe, random);
  std::vector<ArcView> first;
  for (const ArcView& arc : survey.arcs) {
    const bool is_new = std::none_of(first.begin(), first.end(), [&](const ArcView& other) {
      return other.seen.setups == arc.seen.setups && other.shell == arc.shell;
    });
    if (is_new) first.push_back(arc);
  }
  return adjustSetups(first, recipe.setups, {});
}

TEST(SetupAdjustment, TiltsThatShortOverlapsDoNotShowAreAssumed) {
  const SetupAdjustment adjusted = ofShortOverlaps(0.001);
  EXPECT_TRUE(adjusted.height_estimated);
  EXPECT_FALSE(adjusted.tilt_estimated);
  EXPECT_GE(adjusted.spread.tilt, kAssumedTilt - 1e-12);
  EXPECT_GT(ofShortOverlaps(0.008).spread.tilt, 2.0 * kAssumedTilt) << "as heights are seen to err";
  std::mt19937_64 random(3);
  EXPECT_TRUE(adjustSetups(made({}, random).arcs, 6, {}).tilt_estimated);
}

TEST(SetupAdjustment, HeightsThatNothingTellsErrByAsMuchAsPlacesAreSeenTo) {
  Recipe recipe;
  recipe.setups = 12;
  const auto spreadOf = [&](double sigma_plan, const SetupOptions& options) {
    recipe.sigma_plan = sigma_plan;
    std::mt19937_64 random(7);
    Survey survey = made(recipe, random);
    survey.arcs.erase(
        std::remove_if(survey.arcs.begin(), survey.arcs.end(), [](const ArcView& arc) { return !arc.shell; }),
        survey.arcs.end());
    return adjustSetups(survey.arcs, recipe.setups, options).spread;
  };
  const SetupSpread bad = spreadOf(0.006, {});
  EXPECT_GT(bad.plan, 0.003);
  EXPECT_EQ(bad.height, bad.plan);
  EXPECT_NEAR(bad.tilt, kAssumedTilt, 0.05 * kAssumedTilt);  // levelled on the spot; walls tell next to nothing of it
  EXPECT_NEAR(spreadOf(0.0005, {}).height, kAssumedHeight, 1e-11);
  SetupOptions tilt_given;
  tilt_given.tilt = 1e-4;
  EXPECT_EQ(spreadOf(0.006, tilt_given).height, spreadOf(0.006, tilt_given).plan);
}

TEST(SetupAdjustment, HeightsOfFewSetupsAreDrawnToWhatPlacesErrBy) {
  const auto heightOf = [](std::size_t setups, double sigma_plan) {
    constexpr int kSurveys = 10;
    Recipe recipe;
    recipe.setups = setups;
    recipe.sigma_error = 0.001;
    recipe.sigma_plan = sigma_plan;
    double sum = 0.0;
    for (unsigned seed = 1; seed <= kSurveys; ++seed) {
      std::mt19937_64 random(seed);
      const SetupAdjustment adjusted = adjustSetups(made(recipe, random).arcs, setups, {});
      EXPECT_TRUE(adjusted.height_estimated);
      sum += adjusted.spread.height;
    }
    return sum / kSurveys;
  };
  EXPECT_GT(heightOf(5, 0.008), 1.3 * heightOf(5, 0.001));
  EXPECT_LT(heightOf(30, 0.008), 1.2 * heightOf(30, 0.001));  // many tell it themselves
}

TEST(SetupAdjustment, SetupsWithoutAnOverlapKeepTheirPrior) {
  const SetupAdjustment adjusted = adjustSetups({}, 3, {});
  EXPECT_EQ(adjusted.errors.cwiseAbs().maxCoeff(), 0.0);
  EXPECT_NEAR(std::sqrt(adjusted.covariance(5, 5)), kAssumedHeight, 1e-11);
  EXPECT_TRUE(std::isnan(adjusted.all_before));
}

TEST(SetupAdjustment, TenMillimetresOffIsBadAndDrawsNoOther) {
  Recipe recipe;
  recipe.sigma_error = recipe.sigma_plan = 0.0005;
  recipe.sigma_tilt = 2.0 / 3600.0 * kPi / 180.0;
  std::mt19937_64 random(4);
  Survey survey = made(recipe, random);
  survey.errors[5 * 2] += 0.010;
  look(recipe, survey, random);
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, recipe.setups, {});
  for (std::size_t s = 0; s < recipe.setups; ++s) EXPECT_EQ(adjusted.bad[s], s == 2) << s;
  EXPECT_NEAR(adjusted.errors[10], survey.errors[10], 0.001);
  EXPECT_LT(std::abs(adjusted.errors[0]), 0.001);

  SetupOptions keep;
  keep.bad = BadSetups::Keep;
  const SetupAdjustment kept = adjustSetups(survey.arcs, recipe.setups, keep);
  EXPECT_FALSE(kept.bad[2]);
  EXPECT_GT(std::abs(kept.errors[0]), 0.001);  // drawn by the bad one
}

TEST(SetupAdjustment, SixtyArcSecondsOffIsBad) {
  Recipe recipe;
  recipe.sigma_error = recipe.sigma_plan = 0.0005;
  recipe.sigma_tilt = 2.0 / 3600.0 * kPi / 180.0;
  std::mt19937_64 random(6);
  Survey survey = made(recipe, random);
  survey.errors[5 * 3 + 1] += 60.0 / 3600.0 * kPi / 180.0;
  look(recipe, survey, random);
  const SetupAdjustment adjusted = adjustSetups(survey.arcs, recipe.setups, {});
  for (std::size_t s = 0; s < recipe.setups; ++s) EXPECT_EQ(adjusted.bad[s], s == 3) << s;
}

TEST(SetupAdjustment, ArcsWithErrorsTheyDoNotSayAreGivenThem) {
  Recipe recipe;
  recipe.sigma_arc = 0.00002;
  recipe.sigma_unsaid = 0.001;
  recipe.half_view = 40.0 * kPi / 180.0;
  const Tally tally = tallyOf(recipe, {}, 20);
  EXPECT_GT(tally.within, 0.85);
}

}  // namespace tank_datum::setup_adjustment_test
