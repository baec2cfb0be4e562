#include "setups/setup_verdicts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::setup_verdicts_test {

/// A setup whose height was corrected by so many of its standard errors.
Setup corrected(double sigmas) {
  Setup setup;
  setup.points = 1000;
  setup.sigma = SetupMotion::of(SetupMotion::Vector::Constant(0.001));
  setup.correction.dz = -0.001 * sigmas;
  return setup;
}

TEST(SetupVerdict, ACorrectionBeyondThreeOfItsSigmasIsAnAdjustment) {
  EXPECT_EQ(verdictOf(corrected(2.8), false, true), SetupVerdict::Agrees);
  EXPECT_EQ(verdictOf(corrected(3.2), false, true), SetupVerdict::Adjusted);
}

TEST(SetupVerdict, OfASetupThatIsBadAloneOrUnseen) {
  EXPECT_EQ(verdictOf(corrected(9.0), true, true), SetupVerdict::Bad);
  EXPECT_EQ(verdictOf(corrected(9.0), true, false), SetupVerdict::Alone);
  EXPECT_EQ(verdictOf(tank_datum::Setup(), false, true), SetupVerdict::Unseen);
}

TEST(SetupVerdict, ADuplicateHasNineInTenOfItsPointsFromAnother) {
  std::vector<tank_datum::Setup> setups(3, corrected(0.0));
  markDuplicates(setups, {0, {0.0, 0.88, 0.92}});
  EXPECT_NE(setups[1].verdict, SetupVerdict::Duplicate);
  EXPECT_EQ(setups[2].verdict, SetupVerdict::Duplicate);
}

/// How many points are left of ten of a bad setup where a good one has so many in the same arc.
std::size_t leftOfBad(int good) {
  std::vector<tank_datum::Setup> setups(2);
  setups[1].verdict = SetupVerdict::Bad;
  Ring ring;
  for (int i = 0; i < good + 10; ++i) {
    ring.points.push_back({std::cos(toRadians(1.0)), std::sin(toRadians(1.0)), 0.0});
    ring.point_setups.push_back(i < good ? 0 : 1);
  }
  dropBad(ring, setups, {0.0, 0.0});
  return ring.points.size() - static_cast<std::size_t>(good);
}

TEST(DropBad, WhereAHundredPointsOfOthersTellTheFoot) {
  EXPECT_EQ(leftOfBad(98), 10U);
  EXPECT_EQ(leftOfBad(102), 0U);
}

TEST(DropBad, OnlyInTheArcsThatOthersSee) {
  std::vector<tank_datum::Setup> setups(2);
  setups[1].verdict = SetupVerdict::Bad;
  Ring ring;
  for (int i = 0; i < 300; ++i) {  // the bad one alone at 181 degrees
    const double azimuth = toRadians(i < 290 ? 1.0 : 181.0);
    ring.points.push_back({std::cos(azimuth), std::sin(azimuth), 0.0});
    ring.point_setups.push_back(i < 200 ? 0 : 1);
  }
  dropBad(ring, setups, {0.0, 0.0});
  EXPECT_EQ(ring.points.size(), 210U);
  EXPECT_EQ(ring.point_setups.size(), 210U);
}

}  // namespace tank_datum::setup_verdicts_test
