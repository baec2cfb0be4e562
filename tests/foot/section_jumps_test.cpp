#include "foot/section_jumps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tank_datum {
namespace {

constexpr JumpScales kScales{0.0025, 0.008, 0.06};

template <typename Section>
std::vector<SectionBin> binsOf(const Section& section, double error = 1e-4, int count = 40) {
  std::vector<SectionBin> bins;
  for (int i = 0; i < count; ++i) {
    const double d = 0.0165 + 0.003 * i;
    bins.push_back({d, section(d), error});
  }
  return bins;
}

TEST(LineThrough, ASlopeIsObservedBesideWhatIsKnownOfIt) {
  const auto leaning = binsOf([](double d) { return 0.04 * d; }, 1e-3, 3);  // known to 0.001 / sqrt(2) / 0.003 = 0.24
  EXPECT_NEAR(lineThrough(leaning, {0, 3}, 10.0).slope, 0.04, 1e-4);
  EXPECT_NEAR(lineThrough(leaning, {0, 3}, 0.2357).slope, 0.02, 1e-4);
  EXPECT_NEAR(std::sqrt(lineThrough(leaning, {1, 2}, 0.05).varianceAt(0.0)), std::hypot(1e-3, 0.05 * 0.0195), 1e-9);
}

TEST(ClearestJump, IsWhereALipEnds) {
  const Jump jump = clearestJump(binsOf([](double d) { return d < 0.06 ? 0.0 : -0.0075; }), kScales);
  ASSERT_TRUE(jump.found());
  EXPECT_EQ(jump.end, 15U);  // of bins in steps of 3 mm from 16.5 mm on
  EXPECT_EQ(jump.begin, 15U);
}

TEST(ClearestJump, SoSmallThatOneLineGoesThroughBothSidesIsNone) {
  const auto step = [](double by) { return [by](double d) { return d < 0.06 ? 0.0 : -by; }; };
  EXPECT_FALSE(clearestJump(binsOf(step(0.0036), 1e-6), kScales).found());
  EXPECT_TRUE(clearestJump(binsOf(step(0.0046), 1e-6), kScales).found());
}

TEST(ClearestJump, OfLessThanTheLeastIsNone) {
  // three bins on either side, known to 0.1 mm: their lines to 0.4 mm where they meet
  const auto few = [](double by) {
    return clearestJump(binsOf([by](double d) { return d < 0.024 ? 0.0 : -by; }, 1e-4, 6), kScales).found();
  };
  EXPECT_FALSE(few(0.0034));
  EXPECT_TRUE(few(0.0050));
}

TEST(ClearestJump, IsSeenOverBinsThatHoldPointsOfBothSides) {
  const auto blurred = [](double d) { return d < 0.06 ? 0.0 : d > 0.068 ? -0.007 : -0.007 * (d - 0.06) / 0.008; };
  const Jump jump = clearestJump(binsOf(blurred), kScales);
  ASSERT_TRUE(jump.found());
  EXPECT_GT(jump.begin, jump.end);
  // over twice the width that an edge may have it is a ramp, whose parts are no jumps
  const auto ramp = [](double d) { return d < 0.05 ? 0.0 : d > 0.086 ? -0.004 : -0.004 * (d - 0.05) / 0.036; };
  EXPECT_FALSE(clearestJump(binsOf(ramp), {0.0025, 0.0, 0.06}).found());
}

TEST(ClearestJump, ALineOfOneBinIsAsSteepAsFoundationsUsuallyAre) {
  // 5 mm between bins 20 mm apart: slopes of 0.05 either side make 0.7 mm of it, three times that are 2.1 mm
  const auto pair = [](double by) {
    return clearestJump({{0.02, 0.0, 1e-5}, {0.04, -by, 1e-5}}, {0.0025, 0.0, 0.06}).found();
  };
  EXPECT_FALSE(pair(0.0044));
  EXPECT_TRUE(pair(0.0049));
}

TEST(ClearestJump, ToLeaveABinOutMustBeWorthATenth) {
  // one bin between, almost of the lower side: without it the jump is larger by so much
  const auto left_out = [](double above) {
    const auto section = [above](double d) { return d < 0.06 ? 0.0 : d < 0.062 ? above - 0.01 : -0.01; };
    const Jump jump = clearestJump(binsOf(section, 2e-4), kScales);
    return jump.begin - jump.end;
  };
  EXPECT_EQ(left_out(0.0), 0U);
  EXPECT_EQ(left_out(0.005), 1U);
}

TEST(ClearestJump, OfAnEdgeWhoseFaceIsSeenIsAtTheEdge) {
  // a plate 10 mm thick; three bins hold points of its face, one its face and the ringwall [mm]
  const std::vector<double> heights = {0.02,  -0.07, -0.01, 0.05,  0.03,  0.00,  0.02,  -0.05, 0.06,
                                       -0.05, -0.02, 0.00,  0.00,  -0.04, -0.12, -4.46, -4.90, -5.23,
                                       -9.39, -10.0, -10.0, -10.0, -10.0, -10.0, -10.1, -10.0, -10.0};
  std::vector<SectionBin> bins;
  for (const double height : heights)
    bins.push_back({0.0165 + 0.003 * static_cast<double>(bins.size()), 1e-3 * height, 4e-5});
  EXPECT_EQ(clearestJump(bins, {0.0025, 0.009, 0.06}).end, 15U);
}

TEST(LineThrough, IsKnownNoBetterThanBinsLieOnIt) {
  // alternating by two standard errors: of n bins the misfit is 4 n / (n - 1) of what errors explain
  std::vector<SectionBin> bins;
  for (int i = 0; i < 20; ++i) bins.push_back({0.003 * i, i % 2 == 0 ? 0.0002 : -0.0002, 1e-4});
  EXPECT_NEAR(lineThrough(bins, {0, 20}, 0.05).variance, 1e-8 / 20.0 * 4.0 * 20.0 / 19.0, 5e-11);
  for (SectionBin& bin : bins) bin.z = 0.0;
  EXPECT_NEAR(lineThrough(bins, {0, 20}, 0.05).variance, 1e-8 / 20.0, 1e-15) << "never better than their errors say";
}

TEST(ClearestJump, OfABankThatFallsEvenlyIsNone) {
  EXPECT_FALSE(clearestJump(binsOf([](double d) { return -0.37 * d; }), kScales).found());
  EXPECT_FALSE(clearestJump(binsOf([](double d) { return 0.05 - 0.1 * d; }), kScales).found());
}

TEST(ClearestJump, BinsThatErrMoreThanTheySayMakeNone) {
  // alternating by 1.5 mm where 0.1 mm is said: no two lines are known well enough for a step of 4 mm
  const auto uneven = [](double d) {
    return (d < 0.06 ? 0.0 : -0.004) + (std::lround(d / 0.003) % 2 == 0 ? 0.0015 : -0.0015);
  };
  EXPECT_FALSE(clearestJump(binsOf(uneven, 1e-4, 12), kScales).found());
  EXPECT_TRUE(clearestJump(binsOf([](double d) { return d < 0.03 ? 0.0 : -0.004; }, 1e-4, 12), kScales).found());
}

}  // namespace
}  // namespace tank_datum
