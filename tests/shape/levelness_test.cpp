#include "shape/levelness.h"

#include <gtest/gtest.h>

#include <random>

#include "shape/level_rows.h"
#include "stations/ring_series.h"
#include "support/made_surveys.h"

namespace tank_datum::levelness_test {

using namespace made_surveys;

const double kArc = 30.0 * kDegree;  // between stations one degree apart [m]

TEST(Steepest, IsOverTheArcAskedFor) {
  std::vector<double> z(360, 0.0);
  for (std::size_t i = 100; i < 360; ++i) z[i] = 0.02;  // a step at 100 degrees, another at 0
  const auto stations = survey(z, 30.0, 0.001);
  const PlacedValue found = steepest(stations, 30.0, 10.0, &Station::z);
  EXPECT_NEAR(found.value, 0.002, 1e-12);
  EXPECT_NEAR(found.sigma, 0.001 * std::sqrt(2.0) / 10.0, 3e-5);
  EXPECT_NEAR(steepest(stations, 30.0, 4 * kArc, &Station::z).value, 0.02 / (4 * kArc), 1e-9);
}

TEST(Steepest, EndsAtAStationAsWellAsItBegins) {
  std::vector<double> before(360, 0.0), after(360, 0.0);
  before[100] = after[100] = 0.01;
  for (std::size_t i = 78; i < 90; ++i) before[i] = -0.01;
  for (std::size_t i = 111; i < 123; ++i) after[i] = -0.01;
  EXPECT_NEAR(steepest(survey(before, 30.0), 30.0, 10.0, &Station::z).value, 0.002, 1e-12);
  EXPECT_NEAR(steepest(survey(before, 30.0), 30.0, 10.0, &Station::z).azimuth, 100 * kDegree - 5.0 / 30.0, 1e-9);
  EXPECT_NEAR(steepest(survey(after, 30.0), 30.0, 10.0, &Station::z).azimuth, 100 * kDegree + 5.0 / 30.0, 1e-9);
  EXPECT_NEAR(steepest(survey(after, 30.0), 30.0, 10.0, &Station::z).value, 0.002, 1e-12);
}

TEST(Steepest, OfUDoesNotSeeTheTilt) {
  const auto stations = survey(wave(360, [](double a) { return 0.1 * std::cos(a); }), 30.0);
  EXPECT_NEAR(steepest(stations, 30.0, 6.0, &Station::u).value, 0.0, 1e-9);
  EXPECT_GT(steepest(stations, 30.0, 6.0, &Station::z).value, 0.003);
}

TEST(Steepest, NeedsBothEndsAndATankLargeEnough) {
  EXPECT_TRUE(std::isnan(steepest(survey(wave(36, [](double a) { return a; }), 2.0), 2.0, 10.0, &Station::z).value));
  EXPECT_TRUE(std::isnan(steepest({}, 30.0, 10.0, &Station::z).value));
}

TEST(UnevennessWithin, IsHalfTheRangeInTheWindow) {
  std::vector<double> z(360, 0.0);
  z[359] = -0.002, z[4] = 0.004;  // five stations apart over the zero azimuth: 2.6 m
  const auto stations = survey(z, 30.0, 0.001);
  EXPECT_NEAR(unevennessWithin(stations, 30.0, 3.0).value, 0.003, 1e-12);
  EXPECT_NEAR(unevennessWithin(stations, 30.0, 2.0).value, 0.002, 1e-12);
  EXPECT_NEAR(unevennessWithin(stations, 30.0, 3.0).sigma, 0.0005 * std::sqrt(2.0), 1e-12);
  EXPECT_TRUE(std::isnan(unevennessWithin({}, 30.0, 3.0).value));
}

TEST(UnevennessWithin, IsOfPlacesBetweenTheStationsToo) {
  std::vector<double> z(16, 0.0);  // 11.8 m apart: no two within 9 m
  z[5] = 0.0109;
  const auto stations = survey(z, 30.0, 0.001);
  const double apart = kTurn * 30.0 / 16.0;
  EXPECT_NEAR(unevennessWithin(stations, 30.0, 9.0).value, 0.5 * 0.0109 * 9.0 / apart, 1e-9);
  EXPECT_NEAR(unevennessWithin(stations, 30.0, 18.0).value, 0.5 * 0.0109, 1e-9);  // whole, and back again
  z[4] = NAN;
  EXPECT_NEAR(unevennessWithin(survey(z, 30.0), 30.0, 9.0).value, 0.5 * 0.0109 * 9.0 / apart, 1e-9);
  z[6] = NAN;
  EXPECT_NEAR(unevennessWithin(survey(z, 30.0), 30.0, 9.0).value, 0.0, 1e-9) << "nothing is known beside it";
}

TEST(UnevennessWithin, IsThatOfAllPairsOfRandomRings) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int ring = 0; ring < 300; ++ring) {
    const std::size_t count = 3 + random() % 60;
    std::vector<double> z(count);
    for (double& here : z) here = unit(random) < 0.2 ? NAN : 0.02 * unit(random);
    auto stations = survey(z, 10.0, 0.001);
    for (Station& s : stations) s.azimuth += 0.9 * unit(random) * kTurn / static_cast<double>(count);
    const double arc = 70.0 * unit(random);
    const RingSeries series(stations, &Station::z, &Station::sigma_z);
    double most = 0.0;
    for (const RingValue& a : series.values()) {
      for (const RingValue& b : series.values()) {
        if (10.0 * turnAhead(a.azimuth, b.azimuth) <= arc) most = std::max(most, 0.5 * std::abs(b.value - a.value));
      }
      for (const double reach : {arc / 10.0, -arc / 10.0}) {
        const auto there = series.at(a.azimuth + reach);
        if (arc < 10.0 * kTurn / 2.0 && there) most = std::max(most, 0.5 * std::abs(there->value - a.value));
      }
    }
    const PlacedValue found = unevennessWithin(stations, 10.0, arc);
    EXPECT_NEAR(std::isnan(found.value) ? 0.0 : found.value, most, 1e-12) << ring;
    std::vector<double> values;
    for (const RingValue& v : series.values()) values.push_back(v.value);
    EXPECT_NEAR(LevelWithin(series, 10.0, arc).largest(values.data()), most, 1e-12) << ring;
  }
}

TEST(Steepest, IsOfUnevenStationsToo) {
  std::vector<double> azimuths = {0, 20, 35, 65, 90, 110, 130, 150, 180, 200, 225, 250, 275, 300, 320, 340};
  auto stations = survey(std::vector<double>(16, 1.0), 20.0, 0.001);
  for (std::size_t i = 0; i < 16; ++i) stations[i].azimuth = azimuths[i] * kDegree;
  stations[3].z += 0.080;  // 30 degrees from the station before, 25 from the next
  EXPECT_NEAR(steepest(stations, 20.0, 10.0, &Station::z).value, 0.080 / 10.0, 1e-9);
  for (std::size_t i = 4; i < 16; ++i) stations[i].z = 1.080 - 0.006 * static_cast<double>(i - 3);
  EXPECT_NEAR(steepest(stations, 20.0, 10.0, &Station::z).value, 0.080 / (20.0 * 30.0 * kDegree), 1e-9);  // 7.6 mm/m
}

TEST(UnevennessOfAll, CountsEachStationForItsArc) {
  auto stations = survey({0.0, 0.0, 0.0, 0.009, 0.0, 0.0, 0.0, 0.0}, 30.0);
  stations[3].azimuth = 120 * kDegree;  // its neighbours at 90 and 180
  EXPECT_NEAR(unevennessOfAll(stations).value, 0.009 * (1.0 - 45.0 / 360.0), 1e-9);
  stations[4].azimuth = 150 * kDegree;
  EXPECT_NEAR(unevennessOfAll(stations).value, 0.009 * (1.0 - 30.0 / 360.0), 1e-9);
}

TEST(UnevennessOfAll, IsFromTheMean) {
  const PlacedValue found = unevennessOfAll(survey({0.0, 0.0, 0.0, -0.008, NAN, 0.0, 0.0, 0.0, 0.0}, 30.0));
  EXPECT_NEAR(found.value, 0.007, 1e-12);
  EXPECT_NEAR(found.azimuth, 3 * kTurn / 9, 1e-12);
  EXPECT_TRUE(std::isnan(unevennessOfAll({}).value));
}

}  // namespace tank_datum::levelness_test
