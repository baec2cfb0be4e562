#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foot/foot_candidates.h"

namespace tank_datum::foot_stretches_test {

constexpr FootScales kScales{0.3, 0.001, 0.013};  // bins of 6 mm from 13 mm on
constexpr double kBin = 0.006001;

/// A section of so many points in each of so many bins, by bin and by number of the point in it.
template <typename Height>
std::vector<FootPoint> binsOf(int bins, int count, const Height& height) {
  std::vector<FootPoint> points;
  for (int bin = 0; bin < bins; ++bin) {
    for (int i = 0; i < count; ++i) points.push_back({0.0, 0.013 + kBin * (bin + (i + 0.5) / count), height(bin, i)});
  }
  return points;
}

TEST(FindCandidates, AGapOfFiveSpacingsIsChanceOneOfSevenEndsTheSurface) {
  // forty-eight points on 287 mm: 6 mm apart on the average; two points alone make no bin
  const auto end = [](double gap) {
    std::vector<FootPoint> points;
    for (int i = 0; i < 46; ++i) points.push_back({0.0, 0.014 + 0.003 * i, 0.0});
    for (int i = 0; i < 2; ++i) points.push_back({0.0, points.back().d + (i == 0 ? gap : 0.002), 0.0});
    return findCandidates(points, kScales, -kScales.reach).front().to;
  };
  EXPECT_NEAR(end(5.0 * 0.006), 0.149 + 0.030 + 0.002, 0.001);
  EXPECT_NEAR(end(7.0 * 0.006), 0.149, 0.001);
}

TEST(FindCandidates, ABankOfMoreThanFourTenthsIsNoStretch) {
  // a tenth, and a two hundredth of the reach over 6 mm, are 0.35; the bins' own errors make 0.39 of it
  const auto widest = [](double slope) {
    const auto falling = [slope](int bin, int i) { return -slope * kBin * (bin + (i + 0.5) / 400.0); };
    double width = 0.0;
    for (const FootCandidate& c : findCandidates(binsOf(40, 400, falling), kScales, -kScales.reach)) {
      width = std::max(width, c.to - c.from);
    }
    return width;
  };
  EXPECT_NEAR(widest(0.36), 0.24, 0.007);
  EXPECT_LT(widest(0.42), 0.007);
}

/// Bins without noise, the second of them 0.8 mm above the others.
FootCandidate unevenStretch(int bins) {
  return findCandidates(binsOf(bins, 12, [](int bin, int) { return bin == 1 ? 0.0008 : 0.0; }), kScales, -kScales.reach)
      .front();
}

TEST(FindCandidates, OfFourBinsOneMayLieOffOfThreeTheLineIsTheirMean) {
  EXPECT_NEAR(unevenStretch(4).height, 0.0, 1e-6);
  EXPECT_NEAR(unevenStretch(3).height, 0.0008 / 3.0, 1e-6);
}

TEST(FindCandidates, NothingIsKnownOfTheSlopeOfOneBinButThatFoundationsSlopeByATenth) {
  const auto points = binsOf(1, 12, [](int, int) { return 0.0; });
  ASSERT_EQ(findCandidates(points, kScales, -kScales.reach).size(), 1U);
  EXPECT_NEAR(findCandidates(points, kScales, -kScales.reach)[0].sigma_slope, 0.1, 1e-9);
}

/// In how many parts a flat falls with a groove 2 mm deep, so many bins wide, a hundred millimetres from the shell.
std::size_t partsBesideGroove(int width) {
  const auto grooved = [width](int bin, int) { return bin >= 15 && bin < 15 + width ? -0.00205 : 0.0; };
  return findCandidates(binsOf(47, 12, grooved), kScales, -kScales.reach).size();
}

TEST(FindCandidates, AGrooveOfEightBinsPartsTheFlatOneBinOffItDoesNot) {
  EXPECT_EQ(partsBesideGroove(1), 1U);
  EXPECT_GT(partsBesideGroove(8), 1U);
}

}  // namespace tank_datum::foot_stretches_test
