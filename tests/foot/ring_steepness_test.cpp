#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "foot/foot_profile.h"
#include "foot/slanting_beams.h"
#include "support/made_feet.h"

namespace tank_datum::ring_steepness_test {

constexpr double kReach = 0.5, kLevel = 2.0;
constexpr double kFrom = 0.090, kTo = 0.150;  // of what is counted beyond the edge

FootProfile lip() {
  FootProfile profile;
  profile.band_from = 0.015, profile.band_to = 0.055, profile.edge = 0.060;
  profile.noise = 0.001, profile.blur = 0.004;
  return profile;
}

RayCounts countsOf(double d, double z) { return countRays({FootPoint{0.0, d, z}}, lip(), kLevel, kReach); }

TEST(CountRays, BeyondALipsEdgeCountsWhereNoBeamMeetsItTooAndNothingThatStandsThere) {
  const double one = 1.0 / (kTo - kFrom);
  for (const double z : {1.85, 1.99, 2.011}) {
    EXPECT_NEAR(countsOf(kFrom + 0.001, z).beyond, one, 1e-9) << z;
    EXPECT_NEAR(countsOf(kTo - 0.001, z).beyond, one, 1e-9) << z;
  }
  EXPECT_EQ(countsOf(kFrom - 0.001, 1.99).beyond, 0.0);
  EXPECT_EQ(countsOf(kTo + 0.001, 1.99).beyond, 0.0);
  EXPECT_EQ(countsOf(kFrom + 0.001, 2.013).beyond, 0.0) << "8 times the noise and the blur";
}

TEST(RingSteepness, IsThatOfAllWindowsTogetherByTheThinnerOfLipAndWhatLiesBeyond) {
  const std::vector<RayCounts> filled{{40, 1000, 200, 300}, {80, 2000, 200, 900}};
  EXPECT_NEAR(ringSteepness(filled, kReach), 1200.0 * 0.2 / 400.0, 1e-12);
  EXPECT_NEAR(ringSteepness({{40, 1000, 200, 1500}, {80, 2000, 200, 1600}}, kReach), 3000.0 * 0.2 / 400.0, 1e-12);
}

TEST(RingSteepness, WhereNothingIsSeenBeyondIsTheLips) {
  EXPECT_NEAR(ringSteepness({{40, 1000, 200, 0}}, kReach), 1.0, 1e-12);
  EXPECT_EQ(ringSteepness({}, kReach), 0.0) << "not known";
}

/// What is learnt of a lip that beams have filled with points, with so many points a station on what it lies on, which
/// is lifted beside the edge by as much as it is uneven.
/// @param points   of a station on the lip
/// @param band_to  how far out that is plain [m]
FootPriors learntBeside(int beyond, int points = 60, double band_to = 0.060) {
  made_feet::MadeFoot made;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  made.addAll(points, 0.0155, 0.0595, [&](double) { return 1e-4 * normal(random); });
  made.addAll(beyond, kFrom, kTo, [](double) { return -0.010; });
  int shell = 0;
  made.addAll(60, -1e-4, 1e-4, [&](double) { return 0.051 + 0.198 * (shell++ % 60) / 60.0; });
  FootSections sections;
  FootProfile& whole = sections.whole = lip();
  whole.bin = 0.003, whole.band_to = band_to, whole.surface = Surface::AnnularPlate;
  for (std::size_t bin = 0; bin < 100; ++bin) {
    const double d = 0.003 * (static_cast<double>(bin) + 0.5), uneven = bin % 2 == 0 ? 0.0006 : -0.0006;
    whole.height.push_back(d < whole.edge ? 0.0 : d < kFrom ? -0.0092 : -0.010 + uneven);
  }
  sections.stations = 360;
  return learnPriors(made.foot(), {{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)}, sections);
}

TEST(LearnPriors, OfALipThatBeamsFillRaysAreAsFlatAsWhatItLiesOnShows) {
  EXPECT_LT(learntBeside(0).sigma_slope[100], 0.005);
  // by the lift alone, or as much more as its unevenness may hide; and what lips lean by on the average
  const auto sigma = [](double feigned) { return 1.0 / std::hypot(1.0 / feigned, 1.0 / 0.03); };
  const double lift = 0.6 * 3.5 * 0.0008 / 0.06, hidden = 0.6 * 3.5 * 1.4826 * 0.0006 / 0.06;
  EXPECT_GT(learntBeside(1).sigma_slope[100], sigma(lift));
  EXPECT_LT(learntBeside(1).sigma_slope[100], sigma(lift + hidden));
}

TEST(LearnPriors, ALipIsAsWideAsItIsSeenForWhatBeamsFeign) {
  EXPECT_LT(learntBeside(0, 3).sigma_slope[100], 0.005);
  EXPECT_LT(learntBeside(0, 3, 0.045).sigma_slope[100], 0.008);  // 0.017 if it were as wide as it is plain
}

}  // namespace tank_datum::ring_steepness_test
