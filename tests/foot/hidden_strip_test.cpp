#include "foot/hidden_strip.h"

#include <gtest/gtest.h>

namespace tank_datum::hidden_strip_test {

constexpr double kBend = 0.001, kWidth = 0.01;

/// So many strips with so many points, at a height over the surface, give or take so much, that rises so much from
/// strip to strip.
struct StripRun {
  int strips;
  std::size_t points;
  double height = 0.0, off = 0.0005, rise = 0.0;
};

/// So many points of a shell, evenly from one height over the surface to another.
FootStrip shellSeen(double from, double to, std::size_t points) {
  FootStrip shell;
  const double step = (to - from) / static_cast<double>(points);
  for (std::size_t i = 0; i < points; ++i) shell.push_back(from + step * (static_cast<double>(i) + 0.5));
  return shell;
}

/// Twenty strips, from the shell outwards, the last of which are empty.
std::vector<FootStrip> stripsOf(const std::vector<StripRun>& runs) {
  std::vector<FootStrip> strips;
  for (const StripRun& run : runs) {
    for (int k = 0; k < run.strips; ++k) {
      FootStrip strip;
      const double height = run.height + k * run.rise;
      for (std::size_t i = 0; i < run.points; ++i) strip.push_back(height + (i % 2 == 0 ? run.off : -run.off));
      strips.push_back(strip);
    }
  }
  strips.resize(20);
  return strips;
}

/// How many are hidden of twenty strips, from the shell outwards, the last of which are empty.
std::size_t hidden(const std::vector<StripRun>& runs, double bend = kBend, const FootStrip& shell = {}) {
  const std::vector<FootStrip> strips = stripsOf(runs);
  return hiddenStrips({kWidth, strips, strips, shell}, bend);
}

constexpr double kOff = -0.005;  // beyond what a surface is bent by

TEST(HiddenStrips, OfASurfaceThatIsSeenUpToTheShellNoneAre) {
  EXPECT_EQ(hidden({{20, 1000}}), 0U);
  EXPECT_EQ(hidden({{5, 1000}, {1, 2000}}), 0U);  // a lip and its face
  EXPECT_EQ(hidden({}), 0U);
}

TEST(HiddenStrips, AreThoseBeforeACrown) { EXPECT_EQ(hidden({{7, 10, kOff}, {8, 100}, {2, 1000}}), 7U); }

TEST(HiddenStrips, AreNotThoseOfWhichFewPointsAreLeft) {
  EXPECT_EQ(hidden({{7, 10}, {13, 100}}), 0U);  // between plants, or on a wet floor
  EXPECT_EQ(hidden({{7, 0}, {13, 100}}), 0U);   // by a filter of points near edges
}

TEST(HiddenStrips, HaveLessThanTwoThirdsOfThePoints) {
  EXPECT_EQ(hidden({{5, 610, kOff}, {15, 1000}}), 5U);
  EXPECT_EQ(hidden({{5, 690, kOff}, {15, 1000}}), 0U);
}

TEST(HiddenStrips, LieOffTheLineThroughThoseBeyond) {
  EXPECT_EQ(hidden({{5, 600, 0.0009}, {15, 1000}}), 0U);
  EXPECT_EQ(hidden({{5, 600, 0.0013}, {15, 1000}}), 5U);
  EXPECT_EQ(hidden({{5, 600, 0.0013}, {15, 1000}}, 2.0 * kBend), 0U);
  EXPECT_EQ(hidden({{5, 56, 0.0013, 0.0009}, {15, 100}}), 0U);  // three standard errors are 0.4 mm and more
  EXPECT_EQ(hidden({{5, 56, 0.0018, 0.0009}, {15, 100}}), 5U);
}

TEST(HiddenStrips, OrScatterTwiceAsMuch) {
  EXPECT_EQ(hidden({{5, 600, 0.0, 0.00095}, {15, 1000}}), 0U);
  EXPECT_EQ(hidden({{5, 600, 0.0, 0.00105}, {15, 1000}}), 5U);
}

TEST(HiddenStrips, OrTheShellGoesOnBelowThoseBeyond) {
  const std::vector<StripRun> thin{{5, 600}, {15, 1000}}, few{{5, 10, 0.0, 0.001}, {15, 20, 0.0, 0.001}};
  EXPECT_EQ(hidden(thin, kBend, shellSeen(-0.0008, 0.015, 158)), 0U);
  EXPECT_EQ(hidden(thin, kBend, shellSeen(-0.0013, 0.015, 163)), 5U);
  EXPECT_EQ(hidden(thin, 2.0 * kBend, shellSeen(-0.0013, 0.030, 313)), 0U);
  EXPECT_EQ(hidden(few, kBend, shellSeen(-0.0027, 0.015, 177)), 0U);  // three standard errors are 2 mm
  EXPECT_EQ(hidden(few, kBend, shellSeen(-0.0040, 0.015, 190)), 5U);
  EXPECT_EQ(hidden({{20, 1000}}, kBend, shellSeen(-0.015, 0.015, 300)), 0U);
}

/// How many are hidden of strips that rise so much, before so many of so many points each higher up.
std::size_t hiddenRising(double rise, std::size_t points, std::size_t higher, double off = 0.0005) {
  const StripRun rising{7, points, 0.0, off, rise};
  return hiddenStrips({kWidth, stripsOf({rising}), stripsOf({rising, {8, higher, 0.02}}), {}}, kBend);
}

TEST(HiddenStrips, OrTheyRiseMoreSteeplyThanALipToWhatLiesHigher) {
  EXPECT_EQ(hiddenRising(0.0009, 60, 100), 0U);
  EXPECT_NE(hiddenRising(0.0011, 60, 100), 0U);
  EXPECT_EQ(hiddenRising(-0.0011, 60, 100), 0U);
  EXPECT_EQ(hiddenRising(0.0011, 70, 100), 0U);          // as dense as what lies higher
  EXPECT_EQ(hiddenRising(0.0011, 60, 100, 0.0020), 0U);  // three standard errors of 0.06 mm
}

/// Strips beside the shell that rise by so much from strip to strip, to a level surface.
std::vector<StripRun> shoulder(double rise, double step = 0.0) {
  return {{6, 1000, -6.0 * rise - step, 0.0005, rise}, {14, 1000}};
}

TEST(HiddenStrips, OrLieOnASurfaceThatMeetsThoseBeyondAtACrest) {
  EXPECT_NE(hidden(shoulder(0.0010)), 0U);  // 3.5 mm lower in the middle
  EXPECT_EQ(hidden(shoulder(0.0005)) + hidden(shoulder(-0.0010)), 0U);
  EXPECT_EQ(hidden(shoulder(0.0010), 2.0 * kBend), 0U);
  EXPECT_EQ(hidden(shoulder(0.0010, 0.0030)), 0U);                                              // a step, and no crest
  EXPECT_EQ(hidden({{2, 1000, -0.0060}, {2, 1000, 0.0}, {2, 1000, -0.0060}, {14, 1000}}), 0U);  // nor a surface
}

TEST(HiddenStrips, OfAShoulderAreAsDenseAsThoseBeyond) {
  const auto beside = [](std::size_t points) {
    return hidden({{1, 900, -0.0060}, {5, points, -0.0050, 0.0005, 0.0010}, {14, 1000}});
  };
  EXPECT_NE(beside(700), 0U);
  EXPECT_EQ(beside(450), 0U);
}

TEST(HiddenStrips, BesideAShoulderAreOfTheSurfaceThatStationsLieOn) {
  const auto beyond = [inner = shoulder(0.0010)](std::size_t points) {
    return hiddenStrips({kWidth, stripsOf({inner[0], {14, points}}), stripsOf(inner), {}}, kBend);
  };
  EXPECT_NE(beyond(700), 0U);
  EXPECT_EQ(beyond(600), 0U);
}

TEST(HiddenStrips, AreToldByTheShellAsFarBelowAsAbove) {
  FootStrip shell = shellSeen(0.0, 0.015, 150);
  const FootStrip lower = shellSeen(-0.0145, -0.008, 65), lowest = shellSeen(-0.030, -0.016, 140);
  shell.insert(shell.end(), lowest.begin(), lowest.end());
  EXPECT_EQ(hidden({{5, 600}, {15, 1000}}, kBend, shell), 0U);
  shell.insert(shell.end(), lower.begin(), lower.end());
  EXPECT_EQ(hidden({{5, 600}, {15, 1000}}, kBend, shell), 5U);
}

TEST(HiddenStrips, AreComparedWithWhatIsNoUprightFace) {
  EXPECT_EQ(hidden({{5, 600, kOff}, {2, 1000}, {1, 2500, -0.02}, {12, 1000}}), 5U);
  EXPECT_EQ(hidden({{5, 600, kOff}, {1, 1500}, {14, 1000}}), 5U);
}

TEST(HiddenStrips, AreNoneWhereOneOfThemIsDense) {
  EXPECT_EQ(hidden({{1, 700, kOff}, {4, 0}, {15, 1000}}), 0U);  // a plate of which all but a strip is hidden
  EXPECT_EQ(hidden({{1, 600, kOff}, {4, 0}, {15, 1000}}), 5U);
}

TEST(HiddenStrips, HoldPointsOfTheShellThatDoNotCount) {
  const std::vector<FootStrip> strips = stripsOf({{1, 700, kOff}, {4, 500, kOff}, {15, 1000}});
  EXPECT_EQ(hiddenStrips({kWidth, strips, strips, {}, 40.0}, kBend), 0U);
  EXPECT_EQ(hiddenStrips({kWidth, strips, strips, {}, 60.0}, kBend), 5U);
}

TEST(HiddenStrips, AreSoBeyondTwoStandardDeviations) {
  EXPECT_EQ(hidden({{3, 4, kOff}, {17, 10}}), 3U);
  EXPECT_EQ(hidden({{1, 5, kOff}, {2, 4, kOff}, {17, 10}}), 0U);
}

TEST(HiddenStrips, AreThreeAtLeast) {
  EXPECT_EQ(hidden({{2, 10, kOff}, {18, 1000}}), 0U);
  EXPECT_EQ(hidden({{3, 10, kOff}, {17, 1000}}), 3U);
}

TEST(HiddenStrips, AreComparedWithSixBeyond) {
  EXPECT_EQ(hidden({{3, 100, kOff}, {2, 1000}, {15, 100}}), 0U);  // the upright face of something
  EXPECT_EQ(hidden({{3, 10, kOff}, {5, 1000}}), 3U);              // a narrow crown
}

}  // namespace tank_datum::hidden_strip_test
