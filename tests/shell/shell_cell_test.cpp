#include <gtest/gtest.h>

#include "core/units.h"
#include "shell/shell_grid.h"
#include "support/made_shells.h"

namespace tank_datum::shell_cell_test {

using namespace made_shells;

constexpr std::size_t kStation = 180;

/// A shell seen by so many points to a degree, evenly, in a band about one height; about one station it differs.
struct Wall {
  double noise = 0.0, lean = 0.0;
  int per_degree = 80;
  double there_within = 0.0;  ///< of the station that differs [deg]
  double there_noise = 0.0;
  double seen_from = -400.0, seen_to = 400.0;  ///< of what differs, beside the station [deg]
  int there_points = -1;                       ///< within its own degree; -1: as many as elsewhere

  ShellCell cell() const {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    Points points;
    const auto add = [&](double degrees, double sigma, double height) {
      const double a = degrees * kDegree, r = kRadius + lean * height + sigma * normal(random);
      points.emplace_back(kCentre.x() + r * std::cos(a), kCentre.y() + r * std::sin(a), kFoot + 0.3 + height);
    };
    const int count = 360 * per_degree;
    for (int i = 0; i < count; ++i) {
      const double degrees = 360.0 * (i + 0.5) / count, beside = degrees - static_cast<double>(kStation);
      const bool there = std::abs(beside) < there_within;
      if (there && (there_points >= 0 || beside < seen_from || beside > seen_to)) continue;
      add(degrees, there ? there_noise : noise, 0.18 * (std::fmod(0.618034 * i, 1.0) - 0.5));
    }
    for (int i = 0; i < there_points; ++i) {
      const double share = (i + 0.5) / there_points;
      add(static_cast<double>(kStation) + 0.9 * (share - 0.5), there_noise,
          0.18 * (std::fmod(0.618034 * i, 1.0) - 0.5));
    }
    ShellOptions options = everyMetre();
    options.heights = {0.3};
    const ShellGrid grid = fitShellGrid(bandsOf(points, options), stations(), tank10().circle, options);
    return grid.cells.empty() ? ShellCell{} : grid.cells[0][kStation];
  }
};

/// Standard error of a parabola in the middle of n points.
double sigmaOf(double noise, double n) { return 1.5 * noise / std::sqrt(n); }

TEST(ShellCell, IsSeenByFortyPoints) {
  Wall wall;
  wall.there_within = 3.0;
  wall.there_points = 36;
  EXPECT_FALSE(wall.cell().seen());
  wall.there_points = 46;
  EXPECT_TRUE(wall.cell().seen());
}

TEST(ShellCell, BorrowsPointsUntilAQuarterOfAMillimetreIsReached) {
  Wall wall;
  wall.noise = 0.00036 / sigmaOf(1.0, 80.0);  // 0.36 mm of its own degree's points, 0.29 and 0.24 of wider windows
  EXPECT_NEAR(wall.cell().shared, 1.5 * 1.5, 1e-9);
}

TEST(ShellCell, BorrowsFromFortyCentimetresOnEitherSideAtMost) {
  Wall wall;
  wall.noise = 0.005;
  EXPECT_NEAR(wall.cell().shared, std::pow(1.5, 3), 1e-9);  // of 9 cm on either side, at ten metres of radius
}

TEST(ShellCell, ARoofIsFlatterThanOneInFive) {
  Wall wall;
  wall.lean = 0.17;
  EXPECT_TRUE(wall.cell().seen());
  wall.lean = 0.24;
  EXPECT_FALSE(wall.cell().seen());
}

TEST(ShellCell, TheNoiseOfAWiderWindowCountsForEightyPoints) {
  Wall wall;
  wall.noise = 0.0012;
  wall.there_within = 0.5;
  wall.there_noise = 1e-9;  // eighty points that happen to agree: of the wider window more than a fifth
  const double wide_noise = 0.72 * wall.noise, expected = sigmaOf(wide_noise, 80.0) * std::sqrt(80.0 / (80.0 + 80.0));
  EXPECT_NEAR(wall.cell().sigma / expected, 1.0, 0.08);
}

/// Seen on one side of the station alone, where the parabola ends: three times the noise over the root of the points.
ShellCell pastAnEdge(double usual, double there) {
  Wall wall;
  wall.noise = usual, wall.there_noise = there;
  wall.there_within = 4.0;
  wall.seen_from = 0.0;
  return wall.cell();
}

TEST(ShellCell, FourTimesAsUncertainAsUsualItIsNone) {
  const double usual = 0.00018 / sigmaOf(1.0, 80.0);
  EXPECT_NEAR(pastAnEdge(usual, 0.0026).sigma, 0.0006, 0.00005);
  EXPECT_FALSE(pastAnEdge(usual, 0.0038).seen());
}

TEST(ShellCell, KnownToHalfAMillimetreItIsOneHoweverSureTheOthersAre) {
  const double usual = 0.00006 / sigmaOf(1.0, 80.0);
  EXPECT_NEAR(pastAnEdge(usual, 0.0019).sigma, 0.00038, 0.00005);
}

}  // namespace tank_datum::shell_cell_test
