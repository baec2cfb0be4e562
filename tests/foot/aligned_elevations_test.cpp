#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::aligned_elevations_test {

using namespace made_feet;

/// How far elevations that are off by `off`, from station to station up and down, are from a datum of zero that is
/// hidden at every tenth station.
/// @param shell  so many points of every other station are of the shell
double scatterAfter(double off, const std::function<double(double)>& section, int shell = 0) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  MadeFoot made;
  FootElevations elevations;
  for (int s = 0; s < 360; ++s) {
    made.addStation(s, 60, 0.015, 0.3, [&](double d) { return section(d) + 0.0005 * normal(random); });
    made.addStation(s, s % 2 * shell, 0.0, 0.002, [&](double d) { return 150.0 * d; });
    elevations.known.push_back(s % 10 == 0 ? kUnknown : off * std::sin(2.4 * s));
  }
  elevations.filled = elevations.known;
  const FootElevations moved = alignedElevations(made.foot(), elevations);
  double mean = 0.0, squares = 0.0;
  for (int s = 0; s < 360; ++s) {
    const double z = moved.known[static_cast<std::size_t>(s)];
    EXPECT_EQ(std::isfinite(z), s % 10 != 0);
    if (!std::isfinite(z)) continue;
    EXPECT_TRUE(std::isfinite(moved.filled[static_cast<std::size_t>(s)]));
    mean += z / 324.0, squares += z * z / 324.0;
  }
  return std::sqrt(squares - mean * mean);
}

/// How far stations lie off their middle after they were moved, upon a lip before a ringwall whose face, which does not
/// follow the shell and holds most of the points, is so deep.
double scatterBesideFace(double deep) {
  MadeFoot made;
  FootElevations elevations;
  for (int s = 0; s < 360; ++s) {
    made.addStation(s, 60, 0.015, 0.18, [](double d) { return d < 0.05 ? 0.008 : 0.0; });
    const double face = 0.2 + 0.015 * std::sin(1.7 * s);
    made.addStation(s, 150, face, face + 0.002, [&](double d) { return -deep * (d - face) / 0.002; });
    elevations.known.push_back(0.006 * std::sin(2.4 * s));
  }
  elevations.filled = elevations.known;
  double sum = 0.0, squares = 0.0;
  for (const double z : alignedElevations(made.foot(), elevations).known) sum += z / 360.0, squares += z * z / 360.0;
  return std::sqrt(std::max(0.0, squares - sum * sum));
}

TEST(AlignedElevations, StationsMoveTogetherWhereTheirSectionIsOfNoSurface) {
  const auto leaning = [](double d) { return d < 0.05 ? -0.05 * d : -0.018; };
  EXPECT_LT(scatterAfter(0.010, leaning), 0.0005);
}

TEST(AlignedElevations, PointsOfTheShellMoveNoStation) {
  const auto leaning = [](double d) { return d < 0.05 ? -0.05 * d : -0.018; };
  EXPECT_LT(scatterAfter(0.010, leaning, 200), 0.0005);
}

TEST(AlignedElevations, StationsStayWhereTheirSectionIsTheirs) {
  const double off = 0.001;
  EXPECT_NEAR(scatterAfter(off, [](double) { return 0.0; }), off / std::sqrt(2.0), 0.0001);
}

TEST(AlignedElevations, GoByWhatLiesWithinATenthOfTheReachOfTheSurface) {
  EXPECT_LT(scatterBesideFace(0.2), 0.0001);
  EXPECT_LT(scatterBesideFace(0.1), 0.0001);
  EXPECT_GT(scatterBesideFace(0.05), 0.001) << "as high as a crown";
}

}  // namespace tank_datum::aligned_elevations_test
