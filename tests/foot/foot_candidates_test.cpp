#include "foot/foot_candidates.h"

#include <gtest/gtest.h>

#include <random>

namespace tank_datum::foot_candidates_test {

constexpr FootScales kScales{0.3, 0.001, 0.013};

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
  const auto found = findCandidates(lipSection(-0.04), kScales, -kScales.reach);
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
  few.resize(5);
  EXPECT_TRUE(findCandidates(few, kScales, -kScales.reach).empty());
}

/// Points on a line along the section, without noise: `count` in a bin of 6 mm from d = 13 mm on, 47 bins in all.
template <typename Section>
std::vector<FootPoint> rowsOf(int bins, int count, const Section& section) {
  std::vector<FootPoint> points;
  for (int bin = 0; bin < bins; ++bin) {
    for (int i = 0; i < count; ++i) {
      const double d = 0.013 + 0.006 * (bin + (i + 0.5) / count);
      points.push_back({0.0, d, section(d)});
    }
  }
  return points;
}

TEST(FindCandidates, BetweenWideStretchesAStepIsTwoThousandthsOfTheReach) {
  const auto stepped = [](double by) { return [by](double d) { return d < 0.133 ? 0.0 : -by; }; };
  EXPECT_EQ(findCandidates(rowsOf(47, 12, stepped(0.0004)), kScales, -kScales.reach).size(), 1U);  // 0.6 mm
  EXPECT_EQ(findCandidates(rowsOf(47, 12, stepped(0.0010)), kScales, -kScales.reach).size(), 2U);
}

TEST(FindCandidates, TwelvePointsMakeTwoBinsAndALine) {
  std::vector<FootPoint> points;
  for (int i = 0; i < 12; ++i) points.push_back({0.0, 0.02 + 0.25 * i / 12, 0.05 * (0.02 + 0.25 * i / 12)});
  const auto found = findCandidates(points, kScales, -kScales.reach);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].slope, 0.05, 0.02);
  points.resize(5);
  EXPECT_TRUE(findCandidates(points, kScales, -kScales.reach).empty());
}

TEST(FindCandidates, TwoPointsMakeNoBin) {
  auto points = rowsOf(20, 1, [](double) { return 0.0; });  // as sparse as the two
  for (const double d : {0.2500, 0.2505}) points.push_back({0.0, d, 0.0});
  const auto found = findCandidates(points, kScales, -kScales.reach);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LT(found[0].to, 0.15);
}

TEST(FindCandidates, SixPointsMakeAStretch) {
  for (const int count : {5, 6}) {
    auto points = rowsOf(40, 12, [](double) { return 0.0; });
    for (int i = 0; i < count; ++i) points.push_back({0.0, 0.270 + 0.0002 * i, 0.05});
    EXPECT_EQ(findCandidates(points, kScales, -kScales.reach).size(), count == 6 ? 2U : 1U) << count;
  }
}

TEST(FindCandidates, ALipOfAFewPointsIsAStretchOfItsOwn) {
  std::vector<FootPoint> points;
  for (int i = 0; i < 9; ++i) points.push_back({0.0, 0.014 + 0.0025 * i, 1e-5 * (i % 3)});
  for (int i = 0; i < 40; ++i) points.push_back({0.0, 0.110 + 0.0022 * i, 0.013 + 1e-5 * (i % 3)});  // a crown
  const auto found = findCandidates(points, kScales, -kScales.reach);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].height, 0.0, 0.0005);
  EXPECT_LT(found[0].to, 0.04);
  EXPECT_GT(found[1].from, 0.10);
}

TEST(FindCandidates, PointsOnABeamThatGrazesAnEdgeAreNoSurface) {
  const auto found = [](int on_beam) {
    std::vector<FootPoint> points;
    for (int i = 0; i < 150; ++i) points.push_back({0.0, 0.120 + 0.0012 * i, 0.02 + 1e-5 * (i % 3)});
    for (int i = 0; i < on_beam; ++i)
      points.push_back({0.0, 0.014 + 0.1 * i / on_beam, 0.01 + 0.1 * i * 0.1 / on_beam});
    return findCandidates(points, kScales, -kScales.reach).front().from;
  };
  EXPECT_GT(found(25), 0.1) << "three tenths as dense";
  EXPECT_LT(found(60), 0.02) << "seven tenths";
}

TEST(FindCandidates, ABankIsOneSteepStretch) {
  std::vector<FootPoint> points;
  for (int i = 0; i < 200; ++i) points.push_back({0.0, 0.014 + 0.001 * i, 0.07 - 0.37 * (0.001 * i) + 2e-4 * (i % 3)});
  const auto found = findCandidates(points, kScales, -kScales.reach);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].slope, -0.37, 0.01);
}

TEST(FindCandidates, TheShellEndsAtItsThirdLowestPoint) {
  auto points = rowsOf(47, 12, [](double) { return 0.0; });
  for (int i = 0; i < 100; ++i) points.push_back({0.0, 0.0, 0.010 + 0.002 * i});
  EXPECT_NEAR(findCandidates(points, kScales, -kScales.reach)[0].over_foot, -0.014, 0.001);
  for (int i = 0; i < 2; ++i) points.push_back({0.0, 0.0, -0.05});  // stray
  EXPECT_NEAR(findCandidates(points, kScales, -kScales.reach)[0].over_foot, -0.010, 0.001);
}

}  // namespace tank_datum::foot_candidates_test
