#include "foot/section_stretches.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tank_datum::section_stretches_test {

constexpr StepScales kScales{0.0025, 0.008, 0.06};

template <typename Section>
std::vector<SectionBin> binsOf(const Section& section, double error = 1e-4, int count = 40) {
  std::vector<SectionBin> bins;
  for (int i = 0; i < count; ++i) {
    const double d = 0.0165 + 0.003 * i;
    bins.push_back({d, section(d), error});
  }
  return bins;
}

auto stepAt(double at, double by) {
  return [at, by](double d) { return d < at ? 0.0 : -by; };
}

/// Bins before the step; of bins in steps of 3 mm from 16.5 mm on.
template <typename Section>
std::size_t before(const Section& section, double error = 1e-4, int count = 40) {
  return binsBeforeStep(binsOf(section, error, count), kScales);
}

TEST(LineThrough, ASlopeIsObservedBesideWhatIsKnownOfIt) {
  const auto leaning = binsOf([](double d) { return 0.04 * d; }, 1e-3, 3);  // known to 0.001 / sqrt(2) / 0.003 = 0.24
  EXPECT_NEAR(lineThrough(leaning, {0, 3}, 10.0).slope, 0.04, 1e-4);
  EXPECT_NEAR(lineThrough(leaning, {0, 3}, 0.2357).slope, 0.02, 1e-4);
  EXPECT_NEAR(std::sqrt(lineThrough(leaning, {1, 2}, 0.05).varianceAt(0.0)), std::hypot(1e-3, 0.05 * 0.0195), 1e-9);
}

TEST(LineThrough, IsKnownNoBetterThanBinsLieOnIt) {
  // alternating by two standard errors: of n bins the misfit is 4 n / (n - 1) of what errors explain
  std::vector<SectionBin> bins;
  for (int i = 0; i < 20; ++i) bins.push_back({0.003 * i, i % 2 == 0 ? 0.0002 : -0.0002, 1e-4});
  EXPECT_NEAR(lineThrough(bins, {0, 20}, 0.05).variance, 1e-8 / 20.0 * 4.0 * 20.0 / 19.0, 5e-11);
  for (SectionBin& bin : bins) bin.z = 0.0;
  EXPECT_NEAR(lineThrough(bins, {0, 20}, 0.05).variance, 1e-8 / 20.0, 1e-15) << "never better than their errors say";
}

TEST(WithErrorsSeen, AreWidenedWhereBinsScatterAndOnlyThere) {
  const auto seen = withErrorsSeen(binsOf([](double d) {
    return d < 0.076 ? 0.0 : std::lround((d - 0.0165) / 0.003) % 2 == 0 ? 0.001 : -0.001;
  }));
  EXPECT_EQ(seen[5].error, 1e-4);
  EXPECT_EQ(seen[13].error, 1e-4) << "seven bins away";
  EXPECT_GT(seen[25].error, 5e-4);
}

TEST(StretchesOf, AStepParts) {
  const auto stretches = stretchesOf(binsOf(stepAt(0.06, 0.0075)), 0.0005);
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[0].last, 15U);
  EXPECT_EQ(stretches[1].first, 15U);
}

TEST(StretchesOf, AStretchMoreCostsTwelve) {
  // ten bins on either side, known to 1 mm each: two levels 2 s apart leave 20 s^2 of misfit, and a line half of it
  const auto number = [](double by) { return stretchesOf(binsOf(stepAt(0.045, by), 1e-3, 20), 0.0).size(); };
  EXPECT_EQ(number(0.0026), 1U);
  EXPECT_EQ(number(0.0045), 2U);
}

TEST(StretchesOf, ToLeaveABinOutCostsSix) {
  const auto stray = [](double off) {
    const auto section = [off](double d) { return std::abs(d - 0.1335) < 1e-6 ? off : 0.0; };
    return stretchesOf(binsOf(section, 1e-3), 0.0).back().last;  // the last bin of forty
  };
  EXPECT_EQ(stray(0.0022), 40U);
  EXPECT_EQ(stray(0.0030), 39U);
}

TEST(StretchesOf, ASteepLineCosts) {
  // five in a hundred are usual; at seven times that the slope costs 49, and bins would have to be left out for less
  const auto steep = [](double slope) {
    return stretchesOf(binsOf([slope](double d) { return slope * d; }, 1e-3, 8), 0.0).size();
  };
  EXPECT_EQ(steep(-0.2), 1U);
  EXPECT_EQ(steep(-3.0), 0U);
}

TEST(StretchesOf, WhatASurfaceIsOffALineWithoutBeingAnother) {
  const auto wavy = binsOf([](double d) { return 0.0006 * std::sin(d / 0.008); }, 1e-5);
  EXPECT_EQ(stretchesOf(wavy, 0.0005).size(), 1U);
  EXPECT_GT(stretchesOf(wavy, 0.0001).size(), 1U);
}

TEST(BinsBeforeStep, AreThoseOfTheLip) { EXPECT_EQ(before(stepAt(0.06, 0.0075)), 15U); }

TEST(BinsBeforeStep, ALipEndsAtALesserStepThanABlendWithTheShell) {
  // from 1 mm on beside a stretch of 43 mm, from 2.5 mm on beside one of 22 mm; lines are known to 0.2 mm
  EXPECT_EQ(before(stepAt(0.06, 0.0009)), 40U);
  EXPECT_EQ(before(stepAt(0.06, 0.0018)), 15U);
  EXPECT_EQ(before(stepAt(0.04, 0.0026)), 40U);
  EXPECT_EQ(before(stepAt(0.04, 0.0060)), 8U);
}

TEST(BinsBeforeStep, ABlendBetweenIsLeftOut) {
  const auto blurred = [](double d) { return d < 0.06 ? 0.0 : d > 0.068 ? -0.007 : -0.007 * (d - 0.06) / 0.008; };
  EXPECT_NEAR(static_cast<double>(before(blurred)), 15.5, 0.5);
}

TEST(BinsBeforeStep, AGrooveIsPassedOver) {
  const auto groove = [](double width) {
    return before([width](double d) { return d > 0.06 && d < 0.06 + width ? -0.008 : 0.0; });
  };
  EXPECT_EQ(groove(0.006), 40U);
  EXPECT_EQ(groove(0.030), 15U);
}

TEST(BinsBeforeStep, OfAnEdgeJustBeforeTheSectionsEndAreThoseToTheEdge) {
  EXPECT_EQ(before(stepAt(0.13, 0.05)), 38U) << "two bins lie beyond, too narrow for what is passed over";
  EXPECT_EQ(before([](double d) { return d < 0.123 ? 0.0 : -0.05 - 4.0 * (d - 0.123); }), 36U) << "on no line";
  EXPECT_EQ(before(stepAt(0.13, 0.001)), 40U);
}

TEST(BinsBeforeStep, OfAnEdgeWhoseFaceIsSeenAreThoseToTheEdge) {
  // a plate 10 mm thick; three bins hold points of its face, one its face and the ringwall [mm]
  const std::vector<double> heights = {0.02,  -0.07, -0.01, 0.05,  0.03,  0.00,  0.02,  -0.05, 0.06,
                                       -0.05, -0.02, 0.00,  0.00,  -0.04, -0.12, -4.46, -4.90, -5.23,
                                       -9.39, -10.0, -10.0, -10.0, -10.0, -10.0, -10.1, -10.0, -10.0};
  std::vector<SectionBin> bins;
  for (const double height : heights)
    bins.push_back({0.0165 + 0.003 * static_cast<double>(bins.size()), 1e-3 * height, 4e-5});
  EXPECT_EQ(binsBeforeStep(bins, {0.0025, 0.009, 0.06}), 15U);
}

TEST(BinsBeforeStep, OfABankThatFallsEvenlyAreAll) {
  EXPECT_EQ(before([](double d) { return -0.37 * d; }), 40U);
  EXPECT_EQ(before([](double d) { return 0.05 - 0.1 * d; }), 40U);
}

TEST(BinsBeforeStep, WhereTheyErrMoreThanTheySayAreAll) {
  // alternating by 1.5 mm where 0.1 mm is said: no two lines are known well enough for a step of 4 mm
  const auto uneven = [](double d) {
    return (d < 0.03 ? 0.0 : -0.004) + (std::lround(d / 0.003) % 2 == 0 ? 0.0015 : -0.0015);
  };
  EXPECT_EQ(before(uneven, 1e-4, 12), 12U);
  EXPECT_EQ(before(stepAt(0.03, 0.004), 1e-4, 12), 5U);
}

TEST(BinsBeforeStep, AGapTellsNoStepFromASlope) {
  // two rows of bins 60 mm apart and 4 mm different in height: what a slope of 0.05 makes of it; 12 mm are a step
  const auto apart = [](double by) {
    std::vector<SectionBin> bins = binsOf(stepAt(0.08, by), 1e-3);
    bins.erase(bins.begin() + 8, bins.begin() + 28);
    return binsBeforeStep(bins, kScales);
  };
  EXPECT_EQ(apart(0.004), 20U);
  EXPECT_EQ(apart(0.012), 8U);
}

}  // namespace tank_datum::section_stretches_test
