#include "shape/ring_model.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <tuple>

#include "fit/harmonics.h"
#include "shape/arc_points.h"
#include "shape/datum_waves.h"
#include "shape/partial_ring_tilt.h"
#include "support/made_surveys.h"

namespace tank_datum::ring_model_test {

using namespace made_surveys;

RingModel modelOf(const std::vector<double>& z, double sigma, double radius = 30.0) {
  return RingModel(ringData(survey(z, radius, sigma), radius, {}));
}

std::vector<double> level(std::size_t count) {
  return wave(count, [](double) { return 0.0; });
}

TEST(RingModel, MoreThanSixtyFourStationsShowTheirErrorsBesideEachOther) {
  EXPECT_FALSE(modelOf(level(60), 0.001).dense());
  EXPECT_TRUE(modelOf(level(70), 0.001).dense());
}

TEST(RingModel, ItsShortestWaveIsEightDegreesLong) {
  EXPECT_EQ(360 / modelOf(level(400), 0.001).order(), 8);
  EXPECT_EQ(modelOf(level(100), 0.001).order(), 25) << "four stations to a wave";
}

TEST(RingModel, ThreeStationsHaveNoShape) {
  EXPECT_EQ(RingModel(RingData()).order(), 0);
  EXPECT_EQ(modelOf(level(3), 0.001).order(), 0);
  EXPECT_EQ(modelOf(level(4), 0.001).order(), 1);
}

TEST(RingModel, AFoundationUsuallyWavesByOneInFourThousandOfItsRadius) {
  EXPECT_NEAR(ringData(survey(level(8), 40.0, 0.001), 40.0, {}).usual_wave, 0.010, 1e-12);
}

TEST(RingModel, ElevationsWithoutSigmasAreKnownToATenthOfTheirScatterAndOfAMicrometre) {
  const auto sigma = [](double scatter) {
    return modelOf(wave(8, [=](double a) { return scatter * (std::cos(4.0 * a) > 0.0 ? 1.0 : -1.0); }), kUnknown)
        .data()
        .sigmas[0];
  };
  EXPECT_NEAR(sigma(1e-2), 1e-3, 1e-9);
  EXPECT_NEAR(sigma(0.8e-6) / sigma(1.3e-6), 1.0 / 1.3, 0.01);
}

TEST(RingModel, ElevationsWithoutErrorsAreKnownToAHundredThousandthOfTheirScatter) {
  const RingModel model = modelOf(wave(360, [](double a) { return std::cos(3.0 * a); }), kUnknown);
  EXPECT_NEAR(model.noise().scale, 1e-4, 1e-9);  // of a tenth of it
}

TEST(RingModel, WhatTheWavesLeaveIsErrorUnlessNeighboursScatterHalfAsMuch) {
  // a wave too short for the model, which third differences hardly see, on errors of 1 mm as the stations say
  const auto repeatability = [](double amplitude) {
    const auto z = noisy(wave(360, [=](double a) { return amplitude * std::cos(60.0 * a); }), 0.001, 4);
    return modelOf(z, 0.001).noise().repeatability;
  };
  EXPECT_GT(repeatability(0.0020), 1.5);
  EXPECT_LT(repeatability(0.0040), 1.5);
}

/// Stations all round but for so many.
std::vector<double> withGap(std::size_t count, std::size_t missing) {
  std::vector<double> z = level(count);
  for (std::size_t i = 0; i < missing; ++i) z[count / 3 + i] = kUnknown;
  return z;
}

TEST(RingModel, FewStationsHaveTheWavesThatTheClosestNeighboursShow) {
  auto z = level(60);
  for (std::size_t i = 10; i < 30; ++i) z[i] = kUnknown;
  EXPECT_EQ(modelOf(z, 0.001).order(), 29);
  RingData data = ringData(survey(level(12), 30.0, 0.001), 30.0, {});
  data.azimuths[3] = data.azimuths[4] - 0.05;
  EXPECT_EQ(RingModel(data).order(), 62);
  data.azimuths[3] = data.azimuths[4] - 0.01;
  EXPECT_EQ(RingModel(data).order(), 90);
}

TEST(RingModel, ADipOfOneStationSwingsNoGap) {
  // waves of fewer than the ring's half would follow it by swings of metres where nothing was seen
  auto z = wave(72, [](double a) { return 10.0 + 0.01 * std::cos(2.0 * a); });
  z[0] -= 0.02;
  for (const std::size_t first : {27U, 38U, 58U})
    for (std::size_t i = first; i < first + 6; ++i) z[i] = kUnknown;
  const RingModel model = modelOf(z, 1e-4, 45.0);
  Eigen::VectorXd places(360);
  for (Eigen::Index i = 0; i < 360; ++i) places[i] = static_cast<double>(i) * kTurn / 360.0;
  const Eigen::VectorXd datum = model.rowsAt(places) * model.coefficients();
  EXPECT_LT((datum.array() - 10.0).abs().maxCoeff(), 0.05);
}

TEST(RingModel, AShapeBesideAGapThatNoStationShowsLeavesErrorsAndDrawsAsTheyAre) {
  // a sharp step at a gap of 15 degrees: parts of the shapes that describe it lie wholly within the gap
  for (const int sign : {1, -1}) {
    auto z = noisy(wave(360, [](double) { return 10.0; }), 1e-4, 11);
    const auto at = [&](int k) -> double& { return z[static_cast<std::size_t>((360 + sign * k) % 360)]; };
    for (int k = 0; k < 15; ++k) at(160 + k) = kUnknown;
    for (int k = 0; k < 12; ++k) at(159 - k) -= 0.004 * (12 - k) / 12.0;
    const RingModel model = modelOf(z, 1e-4, 6.0);
    EXPECT_LT(model.noise().scale, 2.0);
    const RingModel::Simulated draws = model.simulate(100, 5);
    const Eigen::MatrixXd errors =
        RingModel::product(model.rowsAt(model.data().azimuths), draws.estimate - draws.truth);
    EXPECT_LT(errors.cwiseAbs().maxCoeff(), 2e-3) << "sign " << sign;
  }
}

TEST(HasTiltingGap, OfMoreThanSixDegreesAndTwoAndAHalfUsualSpacings) {
  EXPECT_FALSE(hasTiltingGap(survey(withGap(360, 4), 30.0)));
  EXPECT_TRUE(hasTiltingGap(survey(withGap(360, 7), 30.0)));
  EXPECT_FALSE(hasTiltingGap(survey(withGap(36, 1), 30.0)));
  EXPECT_TRUE(hasTiltingGap(survey(withGap(36, 2), 30.0)));
}

/// Power that a residual wave of 1 mm has beyond a fit of four waves to so many stations, over its mean square.
double powerOf(std::size_t count, int n) {
  WaveData data;
  std::vector<double> residuals;
  for (std::size_t i = 0; i < count; ++i) {
    data.azimuths.push_back(kTurn * static_cast<double>(i) / static_cast<double>(count));
    data.z.push_back(0.0);
    data.weights.push_back(1.0);
    residuals.push_back(0.001 * std::cos(n * data.azimuths.back()));
  }
  return noiseFactor(data, residuals, 4) / 0.5e-6;
}

TEST(NoiseFactor, IsTheMeanPowerOfTheTwentyWavesNextAbove) {
  EXPECT_NEAR(powerOf(360, 20), 360.0 / 2.0 / 20.0, 0.01);
  EXPECT_NEAR(powerOf(360, 27), 0.0, 1e-9);
}

TEST(NoiseFactor, OfStationsForFewerThanEightWavesIsTheMeanSquare) {
  EXPECT_NEAR(powerOf(36, 15), 0.0, 1e-9) << "waves 5 to 12 are looked at";
  EXPECT_NEAR(powerOf(33, 15), 33.0 / (33.0 - 9.0), 0.1);
}

TEST(TellsApart, NoWaveMayBeFiveTimesAsUncertainAsAllRound) {
  for (const auto& [missing, least, most] : {std::tuple(83, 12.5, 25.0), {91, 25.0, 50.0}}) {
    const WaveData data = waveData(survey(withGap(360, static_cast<std::size_t>(missing)), 30.0, 0.001), 1);
    const auto count = static_cast<Eigen::Index>(data.count());
    const Eigen::MatrixXd rows = harmonicRows(Eigen::Map<const Eigen::VectorXd>(data.azimuths.data(), count), 4);
    const double worst = (rows.transpose() * rows).inverse().diagonal().maxCoeff() * static_cast<double>(count) / 2.0;
    EXPECT_GT(worst, least) << missing;
    EXPECT_LT(worst, most) << missing;
    EXPECT_EQ(tellsApart(data, 4), worst < 25.0) << missing;
  }
}

TEST(ArcPoints, AreTwentyFeetApartAndEightToSixtyFour) {
  const auto points = [](double radius) { return ArcPoints(survey(level(360), radius), radius).values().size(); };
  EXPECT_EQ(points(10.0), 10U);
  EXPECT_EQ(points(3.0), 8U);
  EXPECT_EQ(points(100.0), 64U);
}

}  // namespace tank_datum::ring_model_test
