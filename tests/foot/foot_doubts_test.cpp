#include "foot/foot_doubts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_doubts_test {

using namespace made_feet;

/// Three stations of a level ring, not measured from the first of them on, where something so high was refused at the
/// middle one.
std::vector<StationDatum> doubted(double height, std::size_t first = 100, StationFlag flag = StationFlag::Interpolated,
                                  double along = 0.0) {
  MadeFoot made;
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations(360);
  for (StationDatum& s : stations) s.flag = StationFlag::Measured, s.z = 0.0, s.sigma_z = 0.0001;
  for (std::size_t k = 0; k < 3; ++k) stations[(first + k) % 360].flag = flag;
  std::vector<RefusedLevel> refused(360);
  refused[(first + 1) % 360] = {height, along};
  return withRefusedDoubted(stations, refused, foot);
}

TEST(WithRefusedDoubted, TwoStandardErrorsHoldWhatWasRefusedAndWhatLiesBetween) {
  const auto stations = doubted(0.020);
  EXPECT_NEAR(stations[101].sigma_z, 0.5 * 0.020, 1e-5);
  EXPECT_NEAR(stations[100].sigma_z, 0.5 * 0.010, 1e-5);
  EXPECT_NEAR(stations[102].sigma_z, 0.5 * 0.010, 1e-5);
  EXPECT_EQ(stations[101].z, 0.0);
  EXPECT_EQ(stations[99].sigma_z, 0.0001);
  EXPECT_EQ(stations[103].sigma_z, 0.0001);
}

TEST(WithRefusedDoubted, ALowerOneIsHeldAsWell) { EXPECT_NEAR(doubted(-0.020)[101].sigma_z, 0.010, 1e-5); }

TEST(WithRefusedDoubted, GapsOverTheFirstStationAreNoExceptions) {
  EXPECT_NEAR(doubted(0.020, 359)[0].sigma_z, 0.010, 1e-5);
  EXPECT_NEAR(doubted(0.020, 359)[359].sigma_z, 0.005, 1e-5);
}

TEST(WithRefusedDoubted, WhatWasRefusedIsKnownInGapsWithoutABridgeToo) {
  EXPECT_NEAR(doubted(0.020)[101].z_refused, 0.020, 1e-12);
  EXPECT_NEAR(doubted(0.020)[100].z_refused, 0.010, 1e-12);
  EXPECT_TRUE(std::isnan(doubted(0.020)[99].z_refused));
  const auto unbridged = doubted(0.020, 100, StationFlag::Missing);
  EXPECT_NEAR(unbridged[101].z_refused, 0.020, 1e-12);
  EXPECT_EQ(unbridged[101].sigma_z, 0.0001);
}

TEST(WithRefusedDoubted, WhatStepsUpByMoreThanOneInTenIsNoDatum) {
  const double two_stations = 2.0 * kTwoPi / 360.0 * kRadius;
  EXPECT_GT(doubted(0.09 * two_stations)[101].sigma_z, 0.01);
  EXPECT_EQ(doubted(0.11 * two_stations)[101].sigma_z, 0.0001);
}

TEST(WithRefusedDoubted, ADipMayFallByTwoInTen) {
  const double two_stations = 2.0 * kTwoPi / 360.0 * kRadius;
  EXPECT_GT(doubted(-0.19 * two_stations)[101].sigma_z, 0.01);
  EXPECT_EQ(doubted(-0.21 * two_stations)[101].sigma_z, 0.0001);
}

/// Of four stations that were refused, whose own points climb to those in the middle and fall from there.
double sigmaOfClimb(double slope) {
  MadeFoot made;
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations(360);
  for (StationDatum& s : stations) s.flag = StationFlag::Measured, s.z = 0.0, s.sigma_z = 0.0001;
  std::vector<RefusedLevel> refused(360);
  const double step = kTwoPi / 360.0 * kRadius;
  for (const int k : {1, 2, 3, 4}) {
    const double along = k < 3 ? slope : -slope, height = slope * step * (k == 2 || k == 3 ? 1.5 : 0.5);
    stations[static_cast<std::size_t>(100 + k)].flag = StationFlag::Interpolated;
    refused[static_cast<std::size_t>(100 + k)] = {height, along};
  }
  return withRefusedDoubted(stations, refused, foot)[102].sigma_z;
}

TEST(WithRefusedDoubted, WhatStationsThemselvesRiseByIsNoStepUpToOneInFive) {
  EXPECT_GT(sigmaOfClimb(0.19), 0.01);
  EXPECT_GT(sigmaOfClimb(-0.19), 0.01);
  EXPECT_EQ(sigmaOfClimb(0.21), 0.0001);
  EXPECT_EQ(sigmaOfClimb(-0.21), 0.0001);
}

TEST(WithRefusedDoubted, StationsThatDoNotShowHowTheyRiseTellNoStep) {
  const double two_stations = 2.0 * kTwoPi / 360.0 * kRadius;
  EXPECT_GT(doubted(0.19 * two_stations, 100, StationFlag::Interpolated, kUnknown)[101].sigma_z, 0.0001);
  EXPECT_EQ(doubted(0.21 * two_stations, 100, StationFlag::Interpolated, kUnknown)[101].sigma_z, 0.0001);
}

TEST(WithRefusedDoubted, ADipBeginsAtTheStationsBeside) {
  const auto stations = doubted(-0.020);
  for (const std::size_t beside : {99U, 103U}) EXPECT_NEAR(stations[beside].sigma_z, 0.25 * 0.010, 1e-5) << beside;
  for (const std::size_t farther : {98U, 104U}) EXPECT_EQ(stations[farther].sigma_z, 0.0001) << farther;
}

TEST(WithRefusedDoubted, WhereNothingWasRefusedNothingIsDoubted) { EXPECT_EQ(doubted(kUnknown)[101].sigma_z, 0.0001); }

/// The standard error in the middle of five stations, of which the three inner ones may be covered, that rise so much.
double sigmaAt(double rise, double cover, double slope = 0.0) {
  std::vector<FootFit> fits(5);
  for (std::size_t i = 0; i < fits.size(); ++i) {
    fits[i].z = slope * static_cast<double>(i) + (i > 0 && i < 4 ? rise : 0.0), fits[i].sigma = 0.003;
  }
  MadeFoot made(5);
  return withCoverDoubted(fits, {0.0, cover, cover, cover, 0.0}, made.foot())[2].sigma;
}

TEST(WithCoverDoubted, HoldsHalfOfItInOneStandardError) {
  EXPECT_NEAR(sigmaAt(0.010, 0.008), 0.005, 1e-9);
  EXPECT_EQ(sigmaAt(0.010, 0.0), 0.003);
  MadeFoot made;
  EXPECT_EQ(withCoverDoubted(std::vector<FootFit>(1), {}, made.foot()).size(), 1U);
}

TEST(WithCoverDoubted, IsNoMoreThanStationsRiseAboveThoseBeside) {
  EXPECT_NEAR(sigmaAt(0.008, 0.020), 0.005, 1e-9);
  EXPECT_NEAR(sigmaAt(0.008, 0.020, 0.01), 0.005, 1e-9);
  EXPECT_EQ(sigmaAt(0.0, 0.020), 0.003);
  EXPECT_EQ(sigmaAt(-0.010, 0.020), 0.003);
}

TEST(WithCoverDoubted, IsAllOfItWhereNoneStandsBeside) {
  FootFit fit;
  fit.z = 0.0, fit.sigma = 0.003;
  MadeFoot made(2);
  EXPECT_NEAR(withCoverDoubted({fit, {}}, {0.008, 0.0}, made.foot())[0].sigma, 0.005, 1e-9);
}

TEST(WithCoverDoubted, LooksAtStationsEightDegreesBeside) {
  MadeFoot made;
  const auto doubtedWhereLevelFrom = [&](std::size_t from, std::size_t to) {
    std::vector<FootFit> fits(360);
    std::vector<double> cover(360, 0.0);
    for (std::size_t i = 0; i < fits.size(); ++i) {
      const std::size_t away = i > 100 ? i - 100 : 100 - i;
      fits[i].z = away < from || away >= to ? 0.008 : 0.0, fits[i].sigma = 0.003;
    }
    cover[100] = 0.020;
    return withCoverDoubted(fits, cover, made.foot())[100].sigma;
  };
  EXPECT_NEAR(doubtedWhereLevelFrom(7, 10), 0.005, 1e-9);  // it fades out up to there
  EXPECT_EQ(doubtedWhereLevelFrom(10, 30), 0.003);
  EXPECT_EQ(doubtedWhereLevelFrom(2, 6), 0.003);
}

TEST(WithLevelDoubted, TwoStandardErrorsHoldTheOtherLevelOfAllStations) {
  std::vector<FootFit> fits(3);
  for (FootFit& fit : fits) fit.sigma = 0.003;
  fits = withLevelDoubted(std::move(fits), 0.008);
  for (const FootFit& fit : fits) EXPECT_NEAR(fit.sigma, 0.005, 1e-12);
}

TEST(WithFallDoubted, OneStandardErrorHoldsWhatANarrowSurfaceFallsByMoreThanLips) {
  const auto sigma = [](double slope, double edge) {
    FootSections sections;
    sections.whole.edge = edge;
    FootFit fit;
    fit.sigma = 0.0001, fit.slope = slope, fit.middle = 0.04;
    return withFallDoubted({fit}, sections, 0.5)[0].sigma;
  };
  EXPECT_NEAR(sigma(-0.10, 0.10), 0.05 * 0.04, 1e-5);
  EXPECT_NEAR(sigma(-0.05, 0.10), 0.0001, 1e-9);
  EXPECT_NEAR(sigma(0.10, 0.10), 0.0001, 1e-9);
  EXPECT_GT(sigma(-0.10, 0.24), 0.0019);
  EXPECT_NEAR(sigma(-0.10, 0.26), 0.0001, 1e-9) << "a pad";
}

TEST(WithPipeDoubted, TwoStandardErrorsHoldIt) {
  FootSections sections;
  sections.whole.bin = 0.003, sections.whole.edge = 0.03, sections.whole.surface = Surface::AnnularPlate;
  for (int i = 0; i < 100; ++i) sections.whole.height.push_back(i < 10 ? 0.0 : -0.03);
  std::vector<FootFit> fits(2);
  fits[0].sigma = 0.0001;
  const auto doubted = withPipeDoubted(fits, sections, 0.5);
  EXPECT_NEAR(doubted[0].sigma, 0.015, 1e-6);
  EXPECT_FALSE(doubted[1].valid());
}

}  // namespace tank_datum::foot_doubts_test
