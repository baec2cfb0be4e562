#include "foot/foot_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/foot_profile.h"

namespace tank_datum::foot_choice_test {

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

/// A floor that falls to one side, hidden over two arcs of a sixth of the ring each.
Places fallingFloor(double fall) {
  Places places(kPlaces);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    if (i % 180 >= 60 && i % 180 < 120) continue;
    places[i] = {stretch(fall * std::cos(kTwoPi * static_cast<double>(i) / kPlaces), 0.0, 0.0005)};
  }
  return places;
}

TEST(ChooseRoundRing, AFloorThatFallsToOneSideIsOneSurface) {
  const double radius = kArc * kPlaces / kTwoPi;
  EXPECT_EQ(chosen(chooseRoundRing(fallingFloor(0.018 * radius), kArc, kReach)), 240U);
  EXPECT_LT(chosen(chooseRoundRing(fallingFloor(0.022 * radius), kArc, kReach)), 240U) << "as terrain does";
}

TEST(ChooseRoundRing, ATiltIsThatOfMostPlaces) {
  const auto found = [](std::size_t like) {  // of eight places; the others lie elsewhere each, as no surface does
    Places places = fallingFloor(0.2);
    for (std::size_t i = 0; i < kPlaces; ++i) {
      if (!places[i].empty() && i % 8 >= like) places[i] = {stretch(i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0005)};
    }
    return chosen(chooseRoundRing(places, kArc, kReach));
  };
  EXPECT_EQ(found(6), 180U);
  EXPECT_LT(found(3), 90U);
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

TEST(ChooseRoundRing, TellsWhatLiesBetweenPlacesAtDifferentLevels) {
  const auto between = [](double low) {
    Places places(kPlaces, {plate()});
    for (std::size_t i = 100; i < 200; ++i) places[i] = {stretch(-low, 0.0, 0.0005)};
    for (const std::size_t from : {90U, 200U})
      std::fill_n(places.begin() + static_cast<long>(from), 10, Places::value_type{});
    std::vector<bool> found;
    EXPECT_EQ(chosen(chooseRoundRing(places, kArc, kReach, &found)), low > 0.05 ? 240U : 340U);
    return found;
  };
  EXPECT_TRUE(between(0.0).empty());
  const std::vector<bool> found = between(0.1);
  ASSERT_EQ(found.size(), kPlaces);
  EXPECT_EQ(std::count(found.begin(), found.end(), true), 20);
  EXPECT_TRUE(found[90] && found[209]);
}

TEST(ChooseRoundRing, NothingToChooseFromIsNothingChosen) {
  EXPECT_EQ(chosen(chooseRoundRing(Places(kPlaces), kArc, kReach)), 0U);
}

/// What a ring of plates with one odd place makes of it: kept beside 3.5, the cost of a gap of one place.
bool isKept(const FootCandidate& odd, double arc = kArc) {
  Places places(kPlaces, {plate()});
  places[7] = {odd};
  const auto choice = chooseRoundRing(places, arc, kReach);
  EXPECT_EQ(chosen(choice), kPlaces - (choice[7] ? 0 : 1));
  return choice[7].has_value();
}

TEST(ChooseRoundRing, AStretchThatBeginsSevenHundredthsOfTheReachFurtherOutIsKeptOneTwiceAsFarIsNot) {
  const double begins = plate().from;
  EXPECT_TRUE(isKept(stretch(0.0, 0.0, 0.0005, begins + 0.065 * 1.25)));   // cost 3.25
  EXPECT_FALSE(isKept(stretch(0.0, 0.0, 0.0005, begins + 0.075 * 1.25)));  // cost 3.75
}

TEST(ChooseRoundRing, ASlopeOfOneInEightIsKeptOneInSixIsNot) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(isKept(stretch(0.0, sign * 0.125, 0.0005)));
    EXPECT_FALSE(isKept(stretch(0.0, sign * 0.160, 0.0005)));
  }
}

TEST(ChooseRoundRing, AShellSeenTwoMillimetresAndThreeSigmasBelowIsDecisive) {
  EXPECT_TRUE(isKept(stretch(0.0, 0.0, 0.0005, plate().from, 0.0030)));  // 0.004 of the reach and 1.5 mm
  EXPECT_FALSE(isKept(stretch(0.0, 0.0, 0.0005, plate().from, 0.0040)));
}

TEST(ChooseRoundRing, AShellHiddenOverAFifthOfTheReachCountsOne) {
  const double further = plate().from + 0.075;  // cost 3
  EXPECT_TRUE(isKept(stretch(0.0, 0.0, 0.0005, further, -0.08)));
  EXPECT_FALSE(isKept(stretch(0.0, 0.0, 0.0005, further, -0.15)));
}

TEST(ChooseRoundRing, ADatumMayClimbByItsArc) {
  struct Climb {
    double arc, usual;  // between places, and what neighbours there differ by [m]
  };
  // a section's own doubt, 4 mm a metre over four reaches, 1 mm a metre further on
  for (const Climb& c : {Climb{0.2, 0.0164}, Climb{1.9, 0.0249}, Climb{4.0, 0.0274}, Climb{20.0, 0.0434}}) {
    EXPECT_TRUE(isKept(stretch(1.25 * c.usual, 0.0, 0.0005), c.arc)) << c.arc;
    EXPECT_FALSE(isKept(stretch(1.39 * c.usual, 0.0, 0.0005), c.arc)) << c.arc;
  }
}

}  // namespace tank_datum::foot_choice_test
