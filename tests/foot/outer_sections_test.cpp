#include "foot/outer_sections.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

using namespace made_feet;

/// What is usual in bins of 20 mm where a foundation falls by such a slope and, 0.3 m from the shell, by a step [m].
UsualSection usualWithStep(double slope, double step) {
  MadeFoot made;
  made.addAll(400, 0.1, 0.5, [&](double d) { return -slope * d - (d < 0.3 ? 0.0 : step); });
  const std::vector<double> levels(360, 0.0);
  return sectionsBeyond(made.foot(), {}, levels, std::vector<bool>(360, true)).front().usual;
}

TEST(SectionsBeyond, TheBinBeforeAnEdgeTellsNothing) {
  const UsualSection edge = usualWithStep(0.2, 0.014);  // 18 mm where 4 mm are to either side
  EXPECT_TRUE(std::isnan(edge.height[14]));
  EXPECT_TRUE(std::isfinite(edge.height[13]) && std::isfinite(edge.height[15]));
  EXPECT_TRUE(std::isfinite(usualWithStep(0.4, 0.012).height[14]));  // 20 where 8 are
}

TEST(SectionsBeyond, TheBinBehindAnEdgeThatRisesTellsNothing) {
  const UsualSection edge = usualWithStep(0.0, -0.02);
  EXPECT_TRUE(std::isnan(edge.height[15]));
  EXPECT_TRUE(std::isfinite(edge.height[14]) && std::isfinite(edge.height[16]));
}

/// A ring whose sections are level, known to 1 mm, in bins of which one station shows some, so much lower.
RingSections ringOf(std::size_t bins, const std::vector<std::size_t>& shown, double lower) {
  RingSections ring{std::vector<Section>(1, Section(bins, kUnknown)), {Section(bins, 0.0), Section(bins, 0.001), 0, 0}};
  for (const std::size_t b : shown) ring.own[0][b] = -lower;
  return ring;
}

TEST(SectionSeen, OfAStationThatShowsFewBinsOfAnyWidthTheNarrowestTell) {
  const std::vector<RingSections> all = {ringOf(25, {17, 19, 21}, 0.010), ringOf(12, {9}, 0.010), ringOf(6, {}, 0.0)};
  EXPECT_NEAR(SectionSeen(all, 0).depth(0.004).value, 0.010, 1e-12);
}

TEST(SectionSeen, TheDepthThatStandsOutMostCounts) {
  std::vector<RingSections> all = {ringOf(25, {6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19}, 0.008)};
  all[0].own[0][18] = all[0].own[0][19] = -0.080;
  all[0].usual.spread[18] = all[0].usual.spread[19] = 0.025;
  const Depth depth = SectionSeen(all, 0).depth(0.004);
  EXPECT_NEAR(depth.value, 0.008, 0.0005);
  EXPECT_LT(depth.from, 0.4);
}

TEST(SectionSeen, ShowsWhatLiesFartherInTwoBins) {
  const std::vector<RingSections> all = {ringOf(10, {2, 3, 4, 5, 6, 7}, 0.0)};
  EXPECT_TRUE(SectionSeen(all, 0).shows(0.6));
  EXPECT_FALSE(SectionSeen(all, 0).shows(0.7));
}

}  // namespace
}  // namespace tank_datum
