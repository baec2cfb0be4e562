#include "foot/overhang.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics.h"
#include "foot/lowest_layer.h"
#include "foot/section_bins.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::overhang_test {

using Heights = std::vector<std::vector<double>>;

constexpr std::size_t kBins = 40, kFirst = 4;
constexpr OverhangScales kScales{kFirst, 0, 0.012, 0.1};

/// Adds so many points about a height to bins.
void add(Heights& heights, std::size_t first, std::size_t end, double at, int points = 10) {
  for (std::size_t bin = first; bin < end; ++bin) {
    for (int i = 0; i < points; ++i) heights[bin].push_back(at + 0.0001 * i);
  }
}

/// A shell, a lip over bins 1 to 19, and lower ground from bin `ground` on.
Heights lipOver(std::size_t ground, double depth = 0.04) {
  Heights heights(kBins);
  for (double z = 0.01; z < 0.3; z += 0.005) heights[0].push_back(z);
  add(heights, 1, 20, 0.0);
  add(heights, ground, kBins, -depth);
  return heights;
}

std::vector<double> overhangIn(const Heights& heights, const OverhangScales& scales = kScales) {
  std::vector<double> lowest;
  for (std::vector<double> values : heights) {
    if (!values.empty()) keepLowestLayer(values, scales.layer);
    lowest.push_back(median(values));
  }
  return overhangOf(heights, lowest, scales);
}

std::size_t binsOver(const Heights& heights, const OverhangScales& scales = kScales) {
  std::size_t over = 0;
  for (const double level : overhangIn(heights, scales)) over += std::isfinite(level) ? 1 : 0;
  return over;
}

TEST(Overhang, IsWhereALipGoesOnOverSomethingLower) {
  EXPECT_EQ(binsOver(lipOver(12)), 8U);
  EXPECT_NEAR(overhangIn(lipOver(12))[12], 0.0, 0.001);
  EXPECT_TRUE(std::isnan(overhangIn(lipOver(12))[20]));
}

TEST(Overhang, IsNoneWhereWhatIsLowerBeginsAtTheShell) {
  Heights heights = lipOver(1);
  EXPECT_EQ(binsOver(heights), 0U);
}

TEST(Overhang, IsNoneOverMoreThanIsSeenBelowOne) {
  EXPECT_EQ(binsOver(lipOver(12, 0.095)), 8U);
  EXPECT_EQ(binsOver(lipOver(12, 0.105)), 0U);
}

TEST(Overhang, IsNoneWhereTheShellGoesOnBelow) {
  Heights heights = lipOver(12);
  for (double z = -0.09; z < -0.02; z += 0.08) heights[0].push_back(z);
  EXPECT_EQ(binsOver(heights), 8U) << "a stray point";
  for (double z = -0.09; z < -0.02; z += 0.04) heights[0].push_back(z);
  EXPECT_EQ(binsOver(heights), 0U);
}

TEST(Overhang, GoesOnWithATenthOfThePoints) {
  Heights heights = lipOver(kBins);
  add(heights, 12, 20, -0.04, 80);
  EXPECT_EQ(binsOver(heights), 8U);
  add(heights, 12, 20, -0.04, 20);
  EXPECT_EQ(binsOver(heights), 0U);
}

TEST(Overhang, GoesOnWithTenPoints) {
  Heights heights = lipOver(12);
  for (std::size_t bin = 12; bin < 20; ++bin) heights[bin].erase(heights[bin].begin());
  EXPECT_EQ(binsOver(heights), 0U);
}

TEST(Overhang, GoesOnOverThreeBinsWithoutPointsOfIt) {
  const auto with_gap = [](std::size_t bins, const OverhangScales& scales) {
    Heights heights = lipOver(12);
    for (std::size_t bin = 14; bin < 14 + bins; ++bin) {
      heights[bin].clear();
      add(heights, bin, bin + 1, -0.04);
    }
    return binsOver(heights, scales);
  };
  EXPECT_EQ(with_gap(3, kScales), 8U);
  EXPECT_EQ(with_gap(4, kScales), 2U);
  OverhangScales known = kScales;
  known.known = 20;
  EXPECT_EQ(with_gap(4, known), 8U);
}

TEST(Overhang, BeginsWithThreeBinsBesideTheShell) {
  Heights heights = lipOver(12);
  heights[kFirst + 3].clear();
  EXPECT_EQ(binsOver(heights), 8U);
  heights[kFirst + 2].clear();
  EXPECT_EQ(binsOver(heights), 0U);
}

/// How far out a lip of 60 mm is seen to overhang ground that begins so much nearer to the shell, in a section whose
/// noise blurs an edge over 4 mm.
double overhangOfLip(double set_back, double depth) {
  std::vector<std::vector<FootPoint>> stations(360);
  for (auto& station : stations) {
    for (double d = 0.001; d < 0.2; d += 0.001) {
      if (d < 0.060) station.push_back({0.0, d, 0.0});
      if (d > 0.060 - set_back) station.push_back({0.0, d, -depth});
    }
    for (double z = 0.01; z < 0.3; z += 0.01) station.push_back({0.0, 0.0005, z});
  }
  FootProfile profile;
  stackBins(profile, stations, std::vector<double>(360, 0.0), {0.3, 0.001, 0.013});
  return profile.overhang;
}

TEST(StackBins, AnOverhangIsLongerThanAnEdgeIsBlurred) {
  EXPECT_NEAR(overhangOfLip(0.010, 0.04), 0.060, 0.003);
  EXPECT_EQ(overhangOfLip(0.004, 0.04), 0.0);
}

/// Of stations of which a share sees a lip, and the others what lies lower, or some of them both.
bool isSetBackWith(int lip, int lower, int both, int points = 10, double from = 0.03) {
  std::vector<std::vector<FootPoint>> stations;
  const auto add = [&](int count, bool upper, bool under) {
    for (int s = 0; s < count; ++s) {
      stations.emplace_back();
      for (int i = 0; i < points; ++i) {
        if (upper) stations.back().push_back({0.0, 0.04 + 0.001 * i, 0.0});
        if (under) stations.back().push_back({0.0, from + 0.001 * i, -0.04});
      }
    }
  };
  add(lip, true, false), add(lower, false, true), add(both, true, true);
  return isSetBack(stations, std::vector<double>(stations.size(), 0.0), std::vector<double>(100, 0.0), kScales, 0.003,
                   0.004);
}

TEST(IsSetBack, WhereMostStationsSeeBoth) {
  EXPECT_TRUE(isSetBackWith(2, 2, 5));
  EXPECT_FALSE(isSetBackWith(2, 3, 4));
  EXPECT_FALSE(isSetBackWith(50, 50, 0));
  EXPECT_TRUE(isSetBackWith(0, 0, 1, 3));
  EXPECT_FALSE(isSetBackWith(0, 0, 1, 2)) << "nothing tells";
  EXPECT_TRUE(isSetBackWith(0, 0, 1, 10, 0.0430)) << "by 4.2 mm from tenth to tenth, where 4 are blurred";
  EXPECT_FALSE(isSetBackWith(0, 0, 1, 10, 0.0446));
}

TEST(StackBins, AnOverhangIsOverAFifthOfTheReachAtMost) {
  EXPECT_NEAR(overhangOfLip(0.03, 0.055), 0.060, 0.003);
  EXPECT_EQ(overhangOfLip(0.03, 0.065), 0.0);
}

}  // namespace tank_datum::overhang_test
