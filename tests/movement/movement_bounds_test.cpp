#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "fit/harmonics.h"
#include "movement/azimuth_offset.h"
#include "movement/epoch_matching.h"
#include "movement/movement_errors.h"
#include "movement/movement_significance.h"
#include "support/made_epochs.h"

namespace tank_datum::movement_bounds_test {

using namespace made_epochs;

Epoch surveyOf(std::size_t count) {
  Survey survey;
  survey.count = count;
  return survey.epoch();
}

TEST(MatchStations, ElevationsAreInterpolatedBetweenNeighboursTwoDegreesApart) {
  EXPECT_EQ(matchStations(surveyOf(185), surveyOf(17), 0.0).stations.size(), 17U);  // 1.95 degrees apart
  EXPECT_LT(matchStations(surveyOf(176), surveyOf(17), 0.0).stations.size(), 17U);  // 2.05
}

TEST(MatchStations, PlacesAMillionthOfARadianApartAreOne) {
  EXPECT_EQ(matchStations(surveyOf(36), surveyOf(36), 0.8e-6).stations.size(), 36U);
  EXPECT_EQ(matchStations(surveyOf(36), surveyOf(36), 1.3e-6).stations.size(), 0U);
}

TEST(MatchStations, NeighboursShareErrorsOverTwoDegreesAtLeast) {
  const Epoch narrow = with(&Survey::window, 1.0 * kDegree).epoch(),
              wide = with(&Survey::window, 3.0 * kDegree).epoch();
  EXPECT_NEAR(matchStations(narrow, narrow, 0.0).stations[7].window, 2.0 * kDegree, 1e-12);
  EXPECT_NEAR(matchStations(narrow, wide, 0.0).stations[7].window, 3.0 * kDegree, 1e-12);
}

/// A level datum with dips at some azimuths [deg], three stations wide: half, whole and half as deep.
Epoch dipsAt(const std::vector<double>& degrees, double depth) {
  Epoch epoch = Survey().epoch();
  for (std::size_t i = 0; i < epoch.stations.size(); ++i) {
    epoch.stations[i].z = 0.0;
    for (const double at : degrees) {
      const double off = std::abs(static_cast<double>(i) - at);
      if (off < 1.5) epoch.stations[i].z -= off < 0.5 ? depth : 0.5 * depth;
    }
  }
  return epoch;
}

/// So deep that a dip off another one makes the mean square of the differences over their variance so large.
double depthFor(double misfit) { return std::sqrt(misfit * 360.0 / 3.0) * std::sqrt(2.0) * Survey().sigma; }

/// Whether a datum with two dips so far apart tells by which angle a survey of it was turned.
bool tellsItsTurn(double degrees_apart) {
  // turned against itself it departs by three variances, by half of that where dip lies on dip
  const Epoch epoch = dipsAt({100.0, 100.0 + degrees_apart}, depthFor(1.5));
  try {
    return std::abs(estimateOffset(epoch, epoch, {}).value) < 1e-6;
  } catch (const Error&) {
    return false;
  }
}

TEST(EstimateOffset, ATurnThatFitsHalfAsWellIsAnotherOneFromTenDegreesOn) {
  EXPECT_TRUE(tellsItsTurn(7.0));
  EXPECT_FALSE(tellsItsTurn(15.0));
}

TEST(EstimateOffset, ItsErrorIsThatOfTheParabolaThroughTurnsTwoDegreesApart) {
  // two stations aside the squares of the differences add up to 2.5 of the depth's, far away to 3
  const Epoch epoch = dipsAt({100.0}, depthFor(3.0));
  const double curvature = 2.0 * 2.5 / std::pow(2.0 * kDegree, 2.0), independent = 180.0;  // windows of two degrees
  EXPECT_NEAR(estimateOffset(epoch, epoch, {}).sigma / std::sqrt(2.0 / (independent * curvature)), 1.0, 0.03);
}

TEST(CompareEpochs, TwoScansShareAHeightToAThirdOfAMillimetre) {
  const auto dropped = [](double by, bool levelled) {
    Survey first = with(&Survey::sigma, 0.0001, 1), second = with(&Survey::sigma, 0.0001, 2);
    second.lift = -by;
    Epoch before = first.epoch(), after = second.epoch();
    before.levelled = after.levelled = levelled;
    const Movement m = compareEpochs(before, after, {});
    EXPECT_EQ(m.moved(), m.mean_significant);  // its stations share the height
    return m.mean_significant;
  };
  EXPECT_FALSE(dropped(0.00025, false));
  EXPECT_TRUE(dropped(0.0004, false));
  EXPECT_TRUE(dropped(0.00025, true));
}

TEST(CompareEpochs, WhatIsOutOfPlaneIsHeldAgainstTheLargestOfAllStations) {
  // all share a height of 2 mm, so that the stations' own threshold is that of a few; out of plane they are 360
  int moved = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    Epoch before = with(&Survey::sigma, 0.0003, 2 * run).epoch(),
          after = with(&Survey::sigma, 0.0003, 2 * run + 1).epoch();
    for (Epoch* epoch : {&before, &after}) {
      for (Elevation& e : epoch->stations) e.shared = {0.002}, e.sigma_z = std::hypot(e.sigma_z, 0.002);
    }
    const Movement m = compareEpochs(before, after, {});
    moved += m.rest_significant ? 1 : 0;
    EXPECT_GT(m.rest_threshold, m.threshold + 0.5);
  }
  EXPECT_LE(moved, 6);  // binomial(40, 0.05) exceeds it once in 300
}

TEST(CompareEpochs, StationsWithoutAStandardErrorAreNotCompared) {
  Epoch unknown = Survey().epoch();
  unknown.stations[7].sigma_z = 0.0;
  EXPECT_EQ(compareEpochs(Survey().epoch(), unknown, {}).matched, 359U);
  EXPECT_EQ(compareEpochs(unknown, unknown, {}).matched, 359U);
}

TEST(CompareEpochs, NeedsEightStationsInCommon) {
  EXPECT_EQ(compareEpochs(surveyOf(8), surveyOf(8), {}).message, "");
  EXPECT_EQ(compareEpochs(surveyOf(7), surveyOf(7), {}).message,
            "only 7 stations are measured in both surveys, and 8 are needed");
}

std::vector<MatchedStation> stationsAt(std::size_t count, double degrees_apart) {
  std::vector<MatchedStation> stations(count);
  for (std::size_t i = 0; i < count; ++i) {
    stations[i].direction = static_cast<double>(i) * degrees_apart * kDegree;
    stations[i].sigma = 0.001, stations[i].window = 1.0 * kDegree;
  }
  return stations;
}

Significance foundOf(const std::vector<MatchedStation>& stations) {
  const Removed nothing(stations, Removal::Nothing, true);
  return findMoved(stations, drawUnmoved(stations, nothing, nothing, {}, 0.0).dz, {});
}

TEST(FindMoved, OfAnUnmovedTankOneInEightyComparisonsPassesTheThreshold) {
  // six stations that no window joins: none of six normal deviates is beyond 3.08 in 98.75 % of the draws
  EXPECT_NEAR(foundOf(stationsAt(6, 60.0)).threshold, 3.08, 0.15);
}

TEST(FindMoved, AStationTwoAndAHalfSigmasFromItsNeighboursIsTakenForAnError) {
  auto stations = stationsAt(7, 1.0);
  stations[3].dz = 0.0046;
  EXPECT_FALSE(foundOf(stations).moved[3]);
}

TEST(FindMoved, NeighboursAreWithinTwoDegrees) {
  auto stations = stationsAt(180, 2.0);
  stations[50].dz = 0.020;
  EXPECT_TRUE(foundOf(stations).moved[50]) << "it has two, which say nothing of it";
}

/// Stations all round but for so many, with a wave of n = 3 and errors of 1 mm, as they say.
MovementErrors errorsWithGap(std::size_t missing, double& dearest) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 0.001);
  auto stations = stationsAt(360, 1.0);
  stations.resize(360 - missing);
  Eigen::MatrixXd rows(stations.size(), 29);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    stations[i].dz = 0.010 * std::cos(3.0 * stations[i].direction) + normal(random);
    rows.row(static_cast<Eigen::Index>(i)) = harmonicRow(stations[i].direction, 14);
  }
  const Eigen::MatrixXd inverse = (rows.transpose() * rows).inverse();
  dearest = inverse.diagonal().maxCoeff() * static_cast<double>(stations.size()) / 2.0;
  return shownErrors(stations);
}

TEST(ShownErrors, AreAWaveWhereAGapMakesWavesFiveTimesAsUncertain) {
  double dearest = 0.0;
  EXPECT_LT(errorsWithGap(22, dearest).shown, 3.0);
  EXPECT_GT(dearest, 2.5);
  EXPECT_LT(dearest, 5.0);
  EXPECT_GT(errorsWithGap(26, dearest).shown, 3.0);
  EXPECT_GT(dearest, 5.0);
  EXPECT_LT(dearest, 10.0);
}

}  // namespace tank_datum::movement_bounds_test
