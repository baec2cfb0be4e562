#include "foot/foot_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "foot/foot_profile.h"

namespace tank_datum {
namespace {

constexpr double kReach = 0.5, kArc = 0.2;
constexpr std::size_t kPlaces = 360;

using Places = std::vector<std::vector<FootCandidate>>;

FootCandidate stretch(double height, double slope, double noise, double from = 0.013, double over_foot = -0.006) {
  FootCandidate c;
  c.height = height, c.error = 0.0003, c.slope = slope, c.sigma_slope = 0.002;
  c.from = from, c.to = from + 0.05, c.noise = noise, c.over_foot = over_foot;
  return c;
}

FootCandidate plate() { return stretch(0.0, 0.0, 0.0005); }
FootCandidate bank() { return stretch(0.25, -0.6, 0.006, 0.013, -0.01); }

std::size_t chosen(const std::vector<std::optional<std::size_t>>& choice) {
  return static_cast<std::size_t>(std::count_if(choice.begin(), choice.end(), [](const auto& c) { return c; }));
}

TEST(ChooseRoundRing, AFortyDegreePlateIsNotOutvotedByABank) {
  for (const std::size_t seen : {40U, 120U}) {
    Places places(kPlaces, {bank()});
    for (std::size_t i = 100; i < 100 + seen; ++i) places[i] = {plate()};
    const auto choice = chooseRoundRing(places, kArc, kReach);
    EXPECT_EQ(chosen(choice), seen);
    EXPECT_TRUE(choice[100] && choice[100 + seen - 1] && !choice[99]);
  }
}

TEST(ChooseRoundRing, AFlatRoughCoverGivesWayToTheSmoothSurface) {
  Places places(kPlaces, {stretch(0.08, 0.02, 0.008)});
  for (std::size_t i = 0; i < 90; ++i) places[i] = {plate()};
  EXPECT_EQ(chosen(chooseRoundRing(places, kArc, kReach)), 90U);
}

TEST(ChooseRoundRing, TheNearerOfTwoStretchesIsTheSurface) {
  const Places places(kPlaces, {plate(), stretch(-0.01, 0.0, 0.0005, 0.07)});
  for (const auto& c : chooseRoundRing(places, kArc, kReach)) EXPECT_EQ(c.value_or(9), 0U);
}

TEST(ChooseRoundRing, AShellSeenBelowAStretchShowsThatItEndsBefore) {
  Places places(kPlaces, {plate()});
  places[7] = {stretch(0.02, 0.0, 0.0005, 0.06, 0.015)};  // a crown whose lip is hidden
  const auto choice = chooseRoundRing(places, kArc, kReach);
  EXPECT_FALSE(choice[7]);
  EXPECT_EQ(chosen(choice), kPlaces - 1);
}

TEST(ChooseRoundRing, WhereNoPlaceShowsTheLipTheRingwallIsTaken) {
  const Places places(kPlaces, {stretch(-0.01, 0.0, 0.0005, 0.07)});
  EXPECT_EQ(chosen(chooseRoundRing(places, kArc, kReach)), kPlaces);
}

TEST(ChooseRoundRing, NothingToChooseFromIsNothingChosen) {
  EXPECT_EQ(chosen(chooseRoundRing(Places(kPlaces), kArc, kReach)), 0U);
}

/// A section of a plate lip, the ringwall below it and a shell that is seen down to the weld.
std::vector<FootPoint> lipSection(double slope = 0.0) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any;
  std::vector<FootPoint> points;
  for (int i = 0; i < 3000; ++i) {
    const double d = 0.008 + 0.292 * any(random), z = d < 0.065 ? slope * d : -0.010;
    points.push_back({0.0, d, z + 0.0004 * normal(random)});
  }
  for (int i = 0; i < 2000; ++i) points.push_back({0.0, 0.001 * normal(random), 0.007 + 0.4 * any(random)});
  return points;
}

TEST(FindCandidates, AreTheFlatStretchesFromTheShellOutwards) {
  const FootScales scales{0.3, 0.001, 0.013};
  const auto found = findCandidates(lipSection(-0.04), scales);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].height, 0.0, 0.0005);
  EXPECT_NEAR(found[0].slope, -0.04, 0.02);
  EXPECT_NEAR(found[0].to, 0.065, 0.008);
  EXPECT_NEAR(found[0].over_foot, -0.007, 0.003);
  EXPECT_NEAR(found[1].height, -0.010, 0.0005);
  EXPECT_NEAR(found[1].from, 0.065, 0.01);
}

TEST(FindCandidates, AFewPointsMakeNone) {
  std::vector<FootPoint> few = lipSection();
  few.resize(7);
  EXPECT_TRUE(findCandidates(few, {0.3, 0.001, 0.013}).empty());
}

}  // namespace
}  // namespace tank_datum
