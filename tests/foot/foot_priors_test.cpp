#include <gtest/gtest.h>

#include <algorithm>

#include "support/made_feet.h"

namespace tank_datum::foot_priors_test {

using namespace made_feet;

/// What is learnt of the slope where the section looks so.
/// @param blend  how far beams lift what the lip lies on, to 15 mm beyond its edge [m]
FootPriors learnt(MadeFoot& made, Surface surface, double blur = 0.004, double noise = 0.0005, double blend = 0.0) {
  const Foot& foot = made.foot();
  FootSections sections;
  FootProfile& whole = sections.whole;
  const bool lip = surface == Surface::AnnularPlate;
  whole.bin = 0.003, whole.band_from = 0.015, whole.band_to = whole.edge = lip ? 0.06 : 0.3;
  whole.blur = blur, whole.noise = noise, whole.surface = surface;
  for (int i = 0; i < 60; ++i) whole.height.push_back(i < 20 ? 0.0 : i < 25 ? blend - 0.010 : -0.010);
  sections.stations = 360;
  return learnPriors(foot, {{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)}, sections);
}

/// A foot whose foundation is seen at these azimuths alone [deg], sloping.
FootPriors learntFrom(const std::vector<double>& azimuths, Surface surface, double noise = 0.0005) {
  MadeFoot made;
  for (const double azimuth : azimuths) {
    for (int i = 0; i < 200; ++i) {
      const double d = 0.016 + 0.28 * (i + 0.5) / 200.0 * (surface == Surface::AnnularPlate ? 0.15 : 1.0);
      made.add(toRadians(azimuth + 0.1 * (i % 5 - 2)), d, 0.02 * d);
      made.add(toRadians(azimuth + 0.1 * (i % 5 - 2)), 0.0, 0.05 + 0.001 * i);
    }
  }
  return learnt(made, surface, 0.004, noise);
}

TEST(LearnPriors, ADatumBendsLikeEightWavesOfATwoThousandthOfTheRadius) {
  MadeFoot made;
  made.addAll(20, 0.02, 0.28, [](double) { return 0.0; });
  EXPECT_NEAR(learnt(made, Surface::Foundation).sigma_bend, 64.0 / 2000.0 / kRadius, 0.0003);
}

TEST(LearnPriors, UnseenAPadMaySlopeByOneInTenALipByOneInTwenty) {
  MadeFoot pad, lip;
  pad.add(0.0, 0.4, 0.0), lip.add(0.0, 0.4, 0.0);
  EXPECT_NEAR(learnt(pad, Surface::Foundation).sigma_slope[7], 0.1, 1e-12);
  EXPECT_NEAR(learnt(lip, Surface::AnnularPlate).sigma_slope[7], 0.05, 1e-12);
}

TEST(LearnPriors, APadThatSlopesAlikeAllRoundIsKnownToThreeMillimetresAMetre) {
  MadeFoot made;
  made.addAll(40, 0.02, 0.28, [](double d) { return -0.03 * d; });
  const FootPriors priors = learnt(made, Surface::Foundation);
  EXPECT_NEAR(priors.slope[100], -0.03, 1e-4);
  EXPECT_NEAR(priors.sigma_slope[100], 0.003, 1e-5);
  EXPECT_FALSE(priors.settled);
}

TEST(LearnPriors, ThePlacesSeenBestTellHowSteepAPadIs) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const bool best = s < 60;  // the others are seen by a row only
    made.addStation(s, best ? 80 : 2, best ? 0.02 : 0.15, best ? 0.28 : 0.16,
                    [&](double d) { return best ? -0.2 * d : 0.0; });
  }
  EXPECT_NEAR(learnt(made, Surface::Foundation).seen, -0.2, 0.01);
}

TEST(LearnPriors, APadsSlopeIsLookedForOverTenDegreesAndLearntFromSixPlaces) {
  const std::vector<double> six = {4, 64, 124, 184, 244, 304}, five = {4, 64, 124, 184, 244};
  EXPECT_LT(learntFrom(six, Surface::Foundation).sigma_slope[0], 0.05);
  EXPECT_NEAR(learntFrom(five, Surface::Foundation).sigma_slope[0], 0.1, 1e-12);
}

TEST(LearnPriors, ALipsSlopeIsLookedForOverFiveDegrees) {
  const FootPriors priors = learntFrom({102.0}, Surface::AnnularPlate);
  const auto learnt = std::count_if(priors.sigma_slope.begin(), priors.sigma_slope.end(),
                                    [](double sigma) { return std::abs(sigma - 0.05) > 1e-9; });
  EXPECT_GT(learnt, 0);
  EXPECT_NEAR(learntFrom({102.0}, Surface::AnnularPlate).slope[100], 0.02, 0.002);
}

/// A lip that leans alike all round, and a shell seen so steeply that no beam lifts the lip's points.
FootPriors leaningLip(double slope, double blur, double noise, double blend = 0.0) {
  MadeFoot made;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  made.addAll(60, 0.0155, 0.0595, [&](double d) { return slope * d + noise * normal(random); });
  for (int s = 0; s < 360; ++s) {
    for (int i = 0; i < 8; ++i) made.add((s + 0.1 * i - 0.4) * made.step(), 0.0, 0.06 + 0.02 * i);
  }
  return learnt(made, Surface::AnnularPlate, blur, noise, blend);
}

// Beams that lift what lies beside an edge by a fifth of a millimetre may feign three and a half times that, over a
// lip.
constexpr double kBlend = 0.0002, kBlendLean = 3.5 * kBlend / 0.06;

TEST(LearnPriors, ALeanThatBeamsMayFeignIsNone) {
  const FootPriors priors = leaningLip(-0.9 * kBlendLean, 0.002, 1e-5, kBlend);
  EXPECT_NEAR(priors.slope[100], 0.0, 0.1 * kBlendLean);
  EXPECT_NEAR(priors.sigma_slope[100], 0.6 * kBlendLean, 0.1 * kBlendLean);
  EXPECT_NEAR(leaningLip(-0.9 * kBlendLean, 0.002, 1e-5).slope[100], -0.9 * kBlendLean, 0.05 * kBlendLean);
}

TEST(LearnPriors, OfALargerLeanBeamsMayFeignHalfOfTheirMost) {
  const FootPriors priors = leaningLip(-2.0 * kBlendLean, 0.002, 1e-5, kBlend);
  const double usual = 0.03 * 0.03, doubt = 0.36 * kBlendLean * kBlendLean;
  EXPECT_NEAR(priors.slope[100], -1.5 * kBlendLean * usual / (usual + doubt), 0.02 * kBlendLean);
  EXPECT_NEAR(priors.sigma_slope[100], 0.6 * kBlendLean, 0.1 * kBlendLean);
}

TEST(LearnPriors, BeamsFeignNoLipThatRisesOutwards) {
  const FootPriors priors = leaningLip(0.9 * kBlendLean, 0.002, 1e-5, kBlend);
  EXPECT_NEAR(priors.slope[100], 0.9 * kBlendLean, 0.05 * kBlendLean);
}

TEST(LearnPriors, AQuietLipsSlopeIsKnownToAMillimetreAMetre) {
  const FootPriors priors = leaningLip(0.01, 0.0004, 1e-5);
  EXPECT_NEAR(priors.slope[100], 0.01, 0.0005);
  EXPECT_NEAR(priors.sigma_slope[100], 0.001, 0.0002);
  EXPECT_TRUE(priors.settled);
}

// Range noise of 4 mm and a scatter of 0.3 mm may feign a lean of their product over the variance of the distances,
// less by what lies at the band's ends: of 4.5 mm to either side, 4 mm have points as within.
constexpr double kBlur = 0.016, kNoise = 0.0003, kFeigned = 5.0 / 9.0 * 0.25 * kBlur * kNoise / (0.044 * 0.044 / 12.0);

TEST(LearnPriors, ALeanThatRangeNoiseMayFeignIsHardlyAnyAndHalfOfItIsDoubted) {
  // tanks with parallel lips show 0.8 of the doubt 5.9 times as often as others, whose lips lean by 0.03
  const double share = 1.0 / (1.0 + std::exp(-0.32) * 0.03 / kFeigned);
  const FootPriors priors = leaningLip(0.8 * kFeigned, kBlur, kNoise);
  EXPECT_NEAR(priors.slope[100], 0.8 * share * kFeigned, 0.1 * kFeigned);
  const double sigma = kFeigned * std::sqrt(share * (1.0 + (1.0 - share) * 0.64));
  EXPECT_NEAR(priors.sigma_slope[100], std::hypot(0.001, sigma), 0.1 * kFeigned);
}

TEST(LearnPriors, ALargerLeanIsTheLipsOwnAndDoubtedByAsMuch) {
  const FootPriors priors = leaningLip(4.0 * kFeigned, kBlur, kNoise);
  EXPECT_NEAR(priors.slope[100], 4.0 * kFeigned, 0.3 * kFeigned);
  EXPECT_NEAR(priors.sigma_slope[100], std::hypot(0.001, kFeigned), 0.2 * kFeigned);
}

TEST(LearnPriors, LipsOfATankLeanByThreeHundredthsOnTheAverageWhateverWindowsTell) {
  const FootPriors priors = leaningLip(0.0, kBlur, 0.008);  // may feign 0.1, a third of which would be doubted
  EXPECT_NEAR(priors.sigma_slope[100], 0.03 * std::sqrt(0.5), 0.004);  // as many lips are parallel as lean
}

TEST(LearnPriors, OfFewWindowsEachIsWeighedAgainstLipsThatLeanByFiveHundredths) {
  EXPECT_NEAR(learntFrom({102.0}, Surface::AnnularPlate).slope[100], 0.02, 0.001);
  // the noise of the ring counts for ten points beside a window's own 181 to 4 mm before its end, which have none
  const double sigma = 0.05 * std::sqrt(10.0 / 191.0) / (0.038 * std::sqrt(181.0 / 12.0));
  const double weight = 0.0025 / (0.0025 + sigma * sigma);
  EXPECT_NEAR(learntFrom({102.0}, Surface::AnnularPlate, 0.05).slope[100], 0.02 * weight, 0.001);
}

TEST(LearnPriors, ALipsWindowReachesTwoAndAHalfDegrees) {
  const FootPriors priors = learntFrom({102.0}, Surface::AnnularPlate);  // in the window at 100, not in that at 105
  const auto learnt = std::count_if(priors.sigma_slope.begin(), priors.sigma_slope.end(),
                                    [](double sigma) { return std::abs(sigma - 0.05) > 1e-9; });
  EXPECT_EQ(learnt, 10);  // between the windows at 95 and 105
}

/// So many points to a window of five stations, in turn above and below a lip that leans: + - - +.
struct Window {
  int points;
  double slope, noise;
};

template <typename WindowAt>
FootPriors learntOfLips(const WindowAt& window_at, double noise) {
  MadeFoot made;
  for (int k = 0; k < 72; ++k) {
    const Window window = window_at(k);
    for (int i = 0; i < window.points; ++i) {
      const double d = 0.0155 + 0.044 * (i + 0.5) / window.points, sign = i % 4 == 0 || i % 4 == 3 ? 1.0 : -1.0;
      made.add((5 * k - 2 + i % 5) * made.step(), d, window.slope * d + sign / 1.4826 * window.noise);
    }
  }
  for (int s = 0; s < 360; ++s) {
    for (int i = 0; i < 8; ++i) made.add((s + 0.1 * i - 0.4) * made.step(), 0.0, 0.06 + 0.02 * i);
  }
  return learnt(made, Surface::AnnularPlate, 0.0004, noise);
}

TEST(LearnPriors, TheTenthOfTheWindowsSeenBestTellsALipsSlope) {
  const auto window = [](int k) {
    return k < 6 ? Window{500, 0.0, 1e-4} : k < 13 ? Window{55, 0.004, 1e-4} : Window{9, 0.008, 2e-4};
  };
  // the sigma that a tenth are below is that of the second kind: of thirteen windows it is the median
  EXPECT_NEAR(learntOfLips(window, 1e-4).seen, 0.004, 0.0005);
}

TEST(LearnPriors, NeighboursTellALipsSlopeAsFarAsTheyAreAlike) {
  const double noise = 0.002;
  const auto window = [&](int k) { return Window{300, 0.02 * std::cos(k * kTwoPi / 72.0), noise}; };
  const double own = noise / std::sqrt(0.96 * 300.0) / (0.0435 / std::sqrt(12.0));
  const FootPriors priors = learntOfLips(window, noise);
  // a parabola through seven values knows its middle to the root of a third
  EXPECT_LT(priors.sigma_slope[100], std::hypot(0.001, own / std::sqrt(3.0)));
  for (const std::size_t s : {0U, 100U, 300U})
    EXPECT_NEAR(priors.slope[s], window(static_cast<int>(s / 5)).slope, 3.0 * priors.sigma_slope[s]);
}

TEST(LearnPriors, LipsThatLeanInWavesAreFollowedThoughAFewWindowsAreStray) {
  const double noise = 0.0005, amplitude = 0.018;
  const auto wave = [&](int k) { return amplitude * std::cos(2.0 * k * kTwoPi / 72.0); };
  const auto window = [&](int k) { return Window{300, wave(k) + (k % 9 == 4 ? 0.2 : 0.0), noise}; };
  const FootPriors priors = learntOfLips(window, noise);
  double squares = 0;
  for (int s = 0; s < 360; s += 5) squares += std::pow(priors.slope[static_cast<std::size_t>(s)] - wave(s / 5), 2.0);
  EXPECT_LT(std::sqrt(squares / 72.0), 0.25 * amplitude);
  EXPECT_LT(priors.sigma_slope[100], 0.5 * amplitude);
}

TEST(LearnPriors, LipsAlikeAsFarAsWindowsTellMayDifferByASeventhOfTheirScatter) {
  // half of the standard error of their variance: of 72 windows sqrt(0.5 sqrt(2 / 72)) of 0.02, but for the smoothing
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> slopes;
  for (int k = 0; k < 72; ++k) slopes.push_back(0.02 * normal(random));
  const auto window = [&](int k) { return Window{300, slopes[static_cast<std::size_t>(k)], 1e-4}; };
  EXPECT_GT(learntOfLips(window, 1e-4).sigma_slope[100], 0.002);
}

TEST(LearnPriors, WhatSeemsSteeperThanOneInTenIsNoLipsSlope) {
  const auto lip = [](double slope) { return learntOfLips([slope](int) { return Window{300, slope, 1e-3}; }, 1e-3); };
  EXPECT_NEAR(lip(-0.09).slope[100], -0.09, 0.01);
  EXPECT_NEAR(lip(-0.115).slope[100], 0.0, 0.01);
  EXPECT_NEAR(lip(-0.115).sigma_slope[100], 0.05, 0.005);
}

TEST(LearnPriors, WhereBeamsSlantWhatALipLeansBeyondItsOwnSlopeIsFeigned) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    const bool slant = s >= 180;  // the shell is seen, but the lip hardly
    made.addStation(s, slant ? 8 : 60, 0.0155, 0.0595, [slant](double d) { return slant ? -0.04 * (d - 0.037) : 0.0; });
    for (int i = 0; i < 400; i += slant ? 1 : 50) made.add((s + 0.002 * i - 0.4) * made.step(), 0.0, 0.06 + 0.0004 * i);
  }
  const FootPriors priors = learnt(made, Surface::AnnularPlate, 0.002, 1e-5);
  EXPECT_NEAR(priors.slope[270], 0.0, 0.002);
  EXPECT_NEAR(priors.blends.slope[270], -0.04, 0.004);
  EXPECT_EQ(priors.blends.slope[90], 0.0);
  EXPECT_NEAR(priors.blends.level_at, 0.5 * (kScales.weld + 0.06), 1e-9);  // beyond the weld, before the edge
}

}  // namespace tank_datum::foot_priors_test
