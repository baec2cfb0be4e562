#include "tank_datum/movement/movement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/made_epochs.h"
#include "support/refused.h"

namespace tank_datum::movement_test {

using made_epochs::kShared;
using made_epochs::refusal;
using made_epochs::Survey;
using made_epochs::with;

TEST(CompareEpochs, KnowsAnExactMovementAndItsLevelOfDetection) {
  const Movement m = compareEpochs(Survey().epoch(), with(&Survey::dip, 0.002).epoch(), {});
  EXPECT_NEAR(m.stations[100].dz, -0.002, 1e-12);
  EXPECT_NEAR(m.stations[200].dz, 0.0, 1e-12);
  EXPECT_NEAR(m.stations[0].lod95(), 1.96 * std::hypot(0.0003 * std::sqrt(2.0), kShared), 1e-7);
  EXPECT_EQ(m.matched, 360U);
  EXPECT_NEAR(m.max, -0.002, 1e-12);
  EXPECT_NEAR(m.max_azimuth, 100 * kDegree, 1e-9);
}

TEST(CompareEpochs, RemovesWhatIsAskedFor) {
  Survey later = with(&Survey::lift, 0.01);
  later.tilt = 0.004;
  const auto rms = [&](Removal removal) {
    MovementOptions options;
    options.removal = removal;
    return compareEpochs(Survey().epoch(), later.epoch(), options).rms;
  };
  EXPECT_NEAR(rms(Removal::Nothing), std::sqrt(1e-4 + 8e-6), 1e-9);
  EXPECT_NEAR(rms(Removal::Mean), std::sqrt(8e-6), 1e-9);
  EXPECT_NEAR(rms(Removal::Tilt), 0.0, 1e-9);
}

TEST(CompareEpochs, ARegistrationErrorWidensTheLevelOfDetection) {
  MovementOptions options;
  options.registration_error = 0.004;
  const Movement m = compareEpochs(Survey().epoch(), with(&Survey::lift, 0.002).epoch(), options);
  EXPECT_NEAR(m.stations[0].sigma, std::hypot(0.004, 0.0003 * std::sqrt(2.0), kShared), 1e-12);
  EXPECT_EQ(m.significant, 0U);
  EXPECT_EQ(compareEpochs(Survey().epoch(), with(&Survey::lift, 0.002).epoch(), {}).significant, 360U);
}

TEST(CompareEpochs, ARegistrationTiltWidensItByTheHeightAtTheShell) {
  Survey later = with(&Survey::tilt, 0.002);
  MovementOptions options;
  options.registration_tilt = 0.0001;  // 3 mm at 30 m
  const Movement m = compareEpochs(Survey().epoch(), later.epoch(), options);
  EXPECT_NEAR(m.stations[0].sigma, std::hypot(0.003, 0.0003 * std::sqrt(2.0), kShared), 1e-12);
  EXPECT_EQ(m.significant, 0U);
  EXPECT_GT(compareEpochs(Survey().epoch(), later.epoch(), {}).significant, 200U);
}

TEST(CompareEpochs, NeighboursThatShareErrorsProveLess) {
  MovementOptions apart, together;
  apart.correlation = 0.5 * kDegree;
  together.correlation = 20 * kDegree;
  const auto found = [](const MovementOptions& o) {
    return compareEpochs(Survey().epoch(), with(&Survey::lift, 0.0008).epoch(), o).significant;
  };
  EXPECT_EQ(found(apart), 360U);
  EXPECT_EQ(found(together), 0U);
}

TEST(CompareEpochs, CentresAreApartInAFrameThatIsShared) {
  Epoch slid = with(&Survey::lift, 0, 2).epoch();
  slid.circle.center += Eigen::Vector2d(0.03, 0.04);
  EXPECT_NEAR(compareEpochs(Survey().epoch(), slid, {}).centre_apart, 0.05, 1e-12);
  MovementOptions turned;
  turned.azimuth_offset = 1e-3;
  EXPECT_TRUE(std::isnan(compareEpochs(Survey().epoch(), slid, turned).centre_apart));
}

TEST(CompareEpochs, ATiltThatChangesDoesNotTurnTheEstimate) {
  MovementOptions options;
  options.estimate_offset = true;
  Epoch tilted = with(&Survey::turned, 37.25 * kDegree, 2).epoch();
  for (Elevation& e : tilted.stations) e.z += 0.005 * std::cos(e.direction);
  const Movement m = compareEpochs(with(&Survey::lift, 0, 1).epoch(), tilted, options);
  EXPECT_NEAR(m.azimuth_offset, 37.25 * kDegree, 3 * m.sigma_azimuth_offset);
  EXPECT_TRUE(m.tilt_significant);
}

TEST(CompareEpochs, EstimatesTheTurnFromTheShapeWithItsUncertainty) {
  MovementOptions options;
  options.estimate_offset = true;
  const Movement m =
      compareEpochs(with(&Survey::lift, 0, 1).epoch(), with(&Survey::turned, 37.25 * kDegree, 2).epoch(), options);
  EXPECT_GT(m.sigma_azimuth_offset, 0.01 * kDegree);
  EXPECT_LT(m.sigma_azimuth_offset, 2 * kDegree);
  EXPECT_NEAR(m.azimuth_offset, 37.25 * kDegree, 3 * m.sigma_azimuth_offset);
  MovementOptions given;
  given.azimuth_offset = 37.25 * kDegree;
  EXPECT_NEAR(compareEpochs(Survey().epoch(), with(&Survey::turned, 37.25 * kDegree).epoch(), given).rms, 0, 1e-5);
  EXPECT_GT(compareEpochs(Survey().epoch(), with(&Survey::turned, 37.25 * kDegree).epoch(), {}).rms, 0.003);
  Epoch level = Survey().epoch();
  for (Elevation& e : level.stations) e.z = 1.0;
  EXPECT_NE(refusal(level, level, options).find("azimuth offset"), std::string::npos);
}

TEST(CompareEpochs, ComparesSurveysOfOtherStationCountsWhereBothWereMeasured) {
  Survey coarse, fine;
  coarse.count = 36, fine.count = 720;
  const Movement m = compareEpochs(Survey().epoch(), fine.epoch(), {});
  EXPECT_EQ(m.matched, 720U);
  EXPECT_LT(m.rms, 2e-6);  // the baseline's interpolation
  EXPECT_EQ(compareEpochs(coarse.epoch(), Survey().epoch(), {}).matched, 36U);
  Epoch gap = Survey().epoch();
  for (std::size_t i = 40; i < 80; ++i) gap.stations[i].z = NAN;
  const Movement partly = compareEpochs(Survey().epoch(), gap, {});
  EXPECT_EQ(partly.matched, 320U);
  EXPECT_TRUE(std::isnan(partly.stations[50].dz));
  EXPECT_FALSE(partly.stations[50].significant);
  for (std::size_t i = 5; i < 360; ++i) gap.stations[i].z = NAN;
  EXPECT_FALSE(compareEpochs(Survey().epoch(), gap, {}).valid());
  gap.status = "no_tank";
  EXPECT_NE(compareEpochs(Survey().epoch(), gap, {}).message.find("no_tank"), std::string::npos);
}

TEST(CountedAs, TheLastSurveyCountsForThoseBeforeIt) {
  const Epoch baseline = Survey{}.epoch(), earlier = with(&Survey::dip, 0.02).epoch();
  Epoch last = earlier;  // clockwise from +y
  for (Elevation& e : last.stations) e.azimuth = std::fmod(450 * kDegree - e.direction, 360 * kDegree);
  const Movement own = compareEpochs(baseline, earlier, {}), other = countedAs(last, 0.0, own);
  EXPECT_NEAR(own.max_azimuth, 100 * kDegree, 1e-9);
  EXPECT_NEAR(other.max_azimuth, 350 * kDegree, 1e-9);
  EXPECT_NEAR(other.rest_azimuth, 350 * kDegree, 1e-9);
  ASSERT_EQ(other.stations.size(), own.stations.size());
  for (std::size_t i = 0; i < other.stations.size(); ++i) {
    EXPECT_NEAR(other.stations[i].azimuth, static_cast<double>(i) * kDegree, 1e-9);
    EXPECT_EQ(other.stations[i].dz, own.stations[(450 - i) % 360].dz);
  }
  const Movement turned = countedAs(earlier, 10 * kDegree, own);
  EXPECT_NEAR(turned.max_azimuth, 90 * kDegree, 1e-9);
  EXPECT_EQ(countedAs(earlier, 0.0, own).stations.front().azimuth, own.stations.front().azimuth);
}

TEST(CompareEpochs, RefusesOtherTanksUnitsMethodsAndSurfaces) {
  const Epoch one = Survey().epoch();
  Epoch other = one;
  other.circle.radius = 30.06;
  EXPECT_NE(refusal(one, other).find("radius"), std::string::npos);
  MovementOptions wide;
  wide.radius_difference = 0.1;
  EXPECT_EQ(refusal(one, other, wide), "");
  other.circle.radius = 30.0 / 0.3048;
  EXPECT_NE(refusal(one, other).find("ft and m"), std::string::npos);
  other = one, other.circle.center.x() += 0.3;
  EXPECT_NE(refusal(one, other).find("centre"), std::string::npos);
  wide.centre_distance = 0.5;
  EXPECT_EQ(refusal(one, other, wide), "");
  other = one, other.method = "paper";
  EXPECT_NE(refusal(one, other).find("no standard errors"), std::string::npos);
}

TEST(CompareEpochs, RefusesAPlateAndWhatItLiesOnWhereTheyMayLieAPlateApart) {
  const Survey survey = with(&Survey::sigma, 0.0003, 2);
  Epoch plate = survey.epoch();
  plate.surface = "annular_plate";
  const auto refused = [&](const char* surface, double lower, double registration = 0.0) {
    Epoch other = plate;
    other.surface = surface;
    for (Elevation& e : other.stations) e.z -= lower;
    MovementOptions options;
    options.registration_error = registration;
    return refusal(plate, other, options) != "" && refusal(other, plate, options) != "";
  };
  EXPECT_TRUE(refused("ringwall", 0.006));
  EXPECT_TRUE(refused("foundation", 0.0031));
  EXPECT_FALSE(refused("ringwall", 0.0029)) << "half of the thinnest plate: one surface";
  EXPECT_TRUE(refused("ringwall", 0.0, 0.0016)) << "not known well enough";
  EXPECT_FALSE(refused("ringwall", 0.0, 0.0014));
  EXPECT_FALSE(refused("annular_plate", 0.006));
  plate.surface = "foundation";
  EXPECT_FALSE(refused("ringwall", 0.006)) << "one surface, whether its edge is seen or not";
  EXPECT_TRUE(refused("moss", 0.0)) << "no surface that there is";
}

TEST(CompareEpochs, OfASurveyWithItselfKnowsTheTiltNoBetter) {
  const Epoch survey = with(&Survey::sigma, 0.0003, 2).epoch();
  const Movement itself = compareEpochs(survey, survey, {}), twin = compareEpochs(survey, Survey().epoch(), {});
  EXPECT_NEAR(itself.sigma_tilt_change, twin.sigma_tilt_change, 0.2 * twin.sigma_tilt_change);
  MovementOptions options;
  options.correlation = 1e-322;
  EXPECT_NEAR(compareEpochs(survey, survey, options).sigma_mean, kShared, 0.5 * kShared) << "no number too small";
}

TEST(MovementOptions, AreRefusedByName) {
  const auto refused = [](double MovementOptions::*field, double value) {
    MovementOptions options;
    options.*field = value;
    return said(firstError(options));
  };
  EXPECT_EQ(said(firstError(MovementOptions{})), "");
  EXPECT_NE(refused(&MovementOptions::registration_error, -1).find("registration_error"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::registration_tilt, -1).find("registration_tilt"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::correlation, NAN).find("correlation"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::correlation, 6.3).find("correlation"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::azimuth_offset, -6.3).find("azimuth_offset"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::registration_error, 1e160).find("registration_error"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::registration_tilt, 1.58).find("registration_tilt"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::radius_difference, 0).find("radius_difference"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::centre_distance, 0).find("centre_distance"), std::string::npos);
  EXPECT_NE(refused(&MovementOptions::azimuth_offset, INFINITY).find("azimuth_offset"), std::string::npos);
  MovementOptions both;
  both.estimate_offset = true, both.azimuth_offset = 1.0;
  EXPECT_NE(said(firstError(both)).find("azimuth_offset"), std::string::npos);
  EXPECT_NE(refusal(Survey().epoch(), Survey().epoch(), both), "");
}

}  // namespace tank_datum::movement_test
