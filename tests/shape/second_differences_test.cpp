#include "shape/second_differences.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_surveys.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::second_differences_test {

using namespace made_surveys;

double worstOf(const SecondDifferences& d) {
  double worst = 0;
  for (const PlacedValue& v : d.all) worst = std::max(worst, v.value);
  return worst;
}

TEST(SecondDifferencesOf, SixteenStationsOfThePemyPaper) {  // STANDARDS 4.1, in inches
  std::vector<double> z = {-1.10, -1.42, -1.70, -1.73, -1.84, -1.63, -1.50, -0.80,
                           0.00,  -0.54, -0.97, -0.90, -0.80, -1.05, -1.20, -1.17};
  const auto d = secondDifferencesOf(survey(z, 18.288), 18.288, 0);
  EXPECT_EQ(d.points, 16);
  EXPECT_EQ(d.starts, 1);
  EXPECT_EQ(d.all.size(), 16U);
  EXPECT_NEAR(worstOf(d), 0.645, 5e-4);
  EXPECT_NEAR(d.spacing, 7.18, 5e-3);
}

TEST(SecondDifferencesOf, FourteenStationsOfAnInspectionReport) {  // STANDARDS 4.2
  const auto stations = survey(
      {1.050, 1.030, 1.040, 0.980, 0.940, 0.940, 0.980, 1.040, 1.060, 1.065, 1.090, 1.120, 1.090, 1.060}, 21.0312);
  const auto d = secondDifferencesOf(stations, 21.0312, 0);
  const auto third = d.all[2];
  EXPECT_NEAR(third.value, 0.0389, 5e-5);
  EXPECT_NEAR(third.azimuth, 2 * kTurn / 14, 1e-9);
}

TEST(SecondDifferencesOf, DenseStationsAreSurveyedFromEveryStart) {
  const auto stations = survey(wave(360, [](double a) { return 0.01 * std::cos(2 * a); }), 30.0, 0.001);
  const auto d = secondDifferencesOf(stations, 30.0, 0);
  EXPECT_EQ(d.points, 30);  // 188.5 m / 20 ft, even
  EXPECT_EQ(d.starts, 12);
  EXPECT_EQ(d.all.size(), 360U);
  EXPECT_NEAR(worstOf(d), 0.01 * (1 - std::cos(2 * kTurn / 30)), 1e-9);
  EXPECT_NEAR(d.all[0].sigma, 0.001 * std::sqrt(1.5), 1e-9);
  EXPECT_EQ(secondDifferencesOf(stations, 30.0, 36).points, 36);
}

TEST(SecondDifferencesOf, OneDegreeGetsAnExplanationAndNoNumber) {
  const auto stations = survey(wave(360, [](double a) { return 0.01 * std::cos(2 * a); }), 30.0);
  const auto d = secondDifferencesOf(stations, 30.0, 360);
  EXPECT_FALSE(d.valid());
  EXPECT_NE(d.message.find("0.52 m apart"), std::string::npos) << d.message;
  EXPECT_NE(d.message.find("judges noise; 30 to 40 points are sound"), std::string::npos) << d.message;
}

TEST(SecondDifferencesOf, RefusesSurveysTheCodeDoesNotKnow) {
  const auto stations = survey(std::vector<double>(360, 1.0), 30.0);
  EXPECT_NE(secondDifferencesOf(stations, 30.0, 6).message.find("at least 8"), std::string::npos);
  EXPECT_NE(secondDifferencesOf(stations, 30.0, 31).message.find("even"), std::string::npos);
  EXPECT_NE(secondDifferencesOf(stations, 30.0, 10).message.find("9.75 m"), std::string::npos);
  EXPECT_NE(secondDifferencesOf(stations, 30.0, 400).message.find("only 360 stations"), std::string::npos);
  const auto small = survey(std::vector<double>(360, 1.0), 5.0);
  EXPECT_NE(secondDifferencesOf(small, 5.0, 0).message.find("too small"), std::string::npos);
  EXPECT_NE(secondDifferencesOf({}, 18.0, 0).message.find("no stations"), std::string::npos);
}

TEST(SecondDifferencesOf, AStationFurthestOutOfPlaneIsAPointOfOneSurvey) {
  std::vector<double> z(64, 0.0);
  z[8] = -0.030;
  const auto d = secondDifferencesOf(survey(z, 30.0), 30.0, 0);
  EXPECT_EQ(d.points, 30);
  EXPECT_EQ(d.starts, 32);  // 64 stations against 30 points: every second start is another's
  EXPECT_NEAR(d.all[d.worst].value, 0.030, 1e-4);
  EXPECT_NEAR(d.all[d.worst].azimuth, 8 * kTurn / 64, 1e-6);
}

TEST(SecondDifferencesOf, MakesTenSurveysAtLeast) {
  const auto d = secondDifferencesOf(survey(wave(72, [](double a) { return 0.01 * std::cos(2 * a); }), 30.0), 30.0, 36);
  EXPECT_EQ(d.starts, 10);  // each second station is a point: two surveys, and four places between them each
}

TEST(SecondDifferencesOf, UnevenPointsAreTakenAsTheyAre) {
  auto degrees = survey(
      {1.050, 1.030, 1.040, 0.980, 0.940, 0.940, 0.980, 1.040, 1.060, 1.065, 1.090, 1.120, 1.090, 1.060}, 21.0312);
  for (Station& s : degrees) s.azimuth = std::round(s.azimuth / kDegree) * kDegree;
  const auto d = secondDifferencesOf(degrees, 21.0312, 0);
  ASSERT_EQ(d.all.size(), 14U);
  EXPECT_NEAR(d.all[2].value, 0.0389, 5e-4);
  // on a circle of the shape k l^2 / 2 any two arcs give k times their product over two
  std::vector<Station> three = survey({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 10.0);
  three[1].azimuth = 35 * kDegree;
  const double to_before = 350 * kDegree, to_after = 550 * kDegree;  // 10 m radius: arcs of 35 and 55 degrees
  for (Station& s : three) s.u = 0.5 * 0.001 * std::pow(10.0 * (s.azimuth - 35 * kDegree), 2.0);
  const auto bent = secondDifferencesOf(three, 10.0, 0);
  EXPECT_NEAR(bent.all[1].value, 0.5 * 0.001 * to_before * to_after, 1e-9);
  EXPECT_NEAR(bent.spacings[1], std::sqrt(to_before * to_after), 1e-9);
}

TEST(SecondDifferencesOf, LeavesOutPointsInAGap) {
  std::vector<double> z(360, 0.0);
  for (std::size_t i = 100; i < 130; ++i) z[i] = NAN;
  const auto d = secondDifferencesOf(survey(z, 30.0), 30.0, 30);
  EXPECT_EQ(d.all.size(), 360U - 30U - 2U * 12U);
  EXPECT_TRUE(std::none_of(d.all.begin(), d.all.end(), [](const PlacedValue& v) {
    return v.azimuth > 88.5 * kDegree && v.azimuth < 141.5 * kDegree;
  }));
}

}  // namespace tank_datum::second_differences_test
