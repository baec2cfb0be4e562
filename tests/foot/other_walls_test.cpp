#include "foot/other_walls.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tank_datum::other_walls_test {

constexpr double kArc = 0.2;  // between lines [m]

ShellLine lineAt(double radius) {
  ShellLine line;
  line.radius = radius, line.sigma_radius = 0.0002, line.points = 100;
  return line;
}

/// A shell of 10 m whose lines from the first to the last stand out, those beyond them by shares of that.
struct Ring {
  std::vector<ShellLine> lines = std::vector<ShellLine>(360, lineAt(10.0));
  std::vector<bool> strays = std::vector<bool>(360, false);

  Ring(std::size_t first, std::size_t last, double by, const std::vector<double>& beyond = {}) {
    for (std::size_t i = first; i <= last; ++i) put(i, by);
    for (std::size_t k = 0; k < beyond.size(); ++k) {
      put(first - 1 - k, beyond[k] * by);
      put(last + 1 + k, beyond[k] * by);
    }
  }
  std::ptrdiff_t others() const {
    const std::vector<bool> other = findOtherWalls(lines, strays, kArc);
    return std::count(other.begin(), other.end(), true);
  }

 private:
  void put(std::size_t at, double by) {
    lines[at % 360] = lineAt(10.0 + by);
    strays[at % 360] = true;
  }
};

TEST(OtherWalls, CladdingStandsOutByAStepAtBothEnds) {
  EXPECT_EQ(Ring(60, 140, 0.06).others(), 81);
  EXPECT_EQ(Ring(340, 380, 0.06).others(), 41) << "past the first line";
  EXPECT_EQ(Ring(60, 140, 0.03).others(), 0) << "a shell may bend as much";
}

TEST(OtherWalls, ABulgeBeginsWithoutAStep) {
  EXPECT_EQ(Ring(80, 120, 0.06, {0.8, 0.6, 0.4, 0.2}).others(), 0);
  Ring half(60, 140, 0.06);
  half.lines[141] = lineAt(10.04), half.lines[142] = lineAt(10.02);
  half.strays[141] = half.strays[142] = true;
  EXPECT_EQ(half.others(), 0);
}

TEST(OtherWalls, LinesAtAStepBlendWithBoth) {
  EXPECT_EQ(Ring(60, 140, 0.09, {0.95, 0.1}).others(), 85);
  EXPECT_EQ(Ring(60, 140, 0.09, {0.3, 0.3, 0.15}).others(), 87);
  EXPECT_EQ(Ring(60, 140, 0.09, {0.3, 0.3, 0.3, 0.3, 0.15}).others(), 0);
}

TEST(OtherWalls, UnseenLinesAreWiderSteps) {
  Ring ring(60, 140, 0.09);
  ring.lines[59] = ring.lines[141] = {};
  EXPECT_EQ(ring.others(), 81);
  for (const std::size_t i : {58U, 57U, 142U, 143U}) ring.lines[i] = {};
  EXPECT_EQ(ring.others(), 81) << "half a metre and more bends by 79 mm at most";
  EXPECT_EQ(Ring(0, 359, 0.09).others(), 0) << "no shell beside it";
}

TEST(OtherWalls, AStepIsFourStandardErrors) {
  Ring ring(60, 140, 0.05);
  for (ShellLine& line : ring.lines) line.sigma_radius = 0.0025;
  EXPECT_EQ(ring.others(), 81);
  for (ShellLine& line : ring.lines) line.sigma_radius = 0.0045;
  EXPECT_EQ(ring.others(), 0);
}

}  // namespace tank_datum::other_walls_test
