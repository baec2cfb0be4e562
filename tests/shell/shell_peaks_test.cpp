#include "shell/shell_peaks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "stations/stations.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::shell_peaks_test {

constexpr std::size_t kStation = 10;
const std::vector<double> kHeights = {0.3, 0.8, 1.3};

struct Made {
  ShellGrid grid;
  std::vector<std::vector<double>> deviations;
  std::vector<Station> stations = emptyStations({});

  explicit Made(std::vector<double> heights = kHeights) {
    grid.heights = std::move(heights);
    ShellCell cell;
    cell.sigma = 0.0005;
    grid.cells.assign(3, std::vector<ShellCell>(360, cell));
    deviations.assign(3, std::vector<double>(360, 0.0));
    for (std::size_t i = 0; i < 360; ++i) stations[i].azimuth = stations[i].direction;
  }
  double& at(int row, int off) {
    return deviations[static_cast<std::size_t>(row)][kStation + static_cast<std::size_t>(off)];
  }

  Roundness raised(int row = 1) {
    Roundness r;
    r.height = grid.heights[static_cast<std::size_t>(row)];
    r.azimuth = stations[kStation].azimuth;
    r.sigma = 0.0003;
    r.max_deviation = std::max(0.0, at(row, 0)), r.min_deviation = std::min(0.0, at(row, 0));
    std::vector<Roundness> all = {r};
    raisePeaks(all, grid, deviations, stations);
    return all.front();
  }
};

TEST(RaisePeaks, APeakBetweenTwoStationsIsThatOfTheParabola) {
  Made made;
  for (int off = -1; off <= 1; ++off)
    made.at(1, off) = made.at(0, off) = made.at(2, off) = 0.08 - 0.01 * (off - 0.3) * (off - 0.3);
  const Roundness r = made.raised();
  EXPECT_NEAR(r.max_deviation, 0.08, 1e-9);
  EXPECT_NEAR(r.sigma, std::hypot(0.0003, 0.01 * 0.09), 1e-9);
  EXPECT_EQ(r.min_deviation, 0.0);
}

TEST(RaisePeaks, APeakBetweenTwoHeightsToo) {
  Made made;
  made.at(0, 0) = 0.0, made.at(1, 0) = made.at(2, 0) = -0.049;  // inwards, midway
  for (int off : {-1, 1}) made.at(1, off) = -0.049;
  EXPECT_NEAR(made.raised().min_deviation, -0.049 - 0.049 / 8.0, 1e-9);
  EXPECT_NEAR(made.raised(2).min_deviation, -0.049, 1e-9) << "nothing is known above";
  Made uneven({0.3, 0.8, 1.8});
  uneven.at(1, 0) = uneven.at(2, 0) = uneven.at(1, -1) = uneven.at(1, 1) = -0.049;
  EXPECT_NEAR(uneven.raised().min_deviation, -0.049, 1e-9);
}

TEST(RaisePeaks, ANarrowPeakMayRiseByWhatLiesBesideIt) {
  Made made;
  made.at(1, 0) = 0.030, made.at(1, 1) = 0.012;  // of one of 42 mm that is two steps wide
  EXPECT_NEAR(made.raised().may_rise, 0.012, 1e-9);
  made.at(2, 0) = 0.030;
  EXPECT_NEAR(made.raised().may_rise, 0.012 + 0.015, 1e-9);
  EXPECT_NEAR(made.raised().rise, 0.006 * 0.006 / (4.0 * 0.024) + 0.015 / 4.0, 1e-9);
}

TEST(RaisePeaks, APeakedWeldIsMoreThanItsMeanOverAStation) {
  Made made;
  made.at(1, 0) = 0.020, made.at(1, 1) = made.at(1, -1) = 0.006;
  EXPECT_NEAR(made.raised().may_rise, 0.5 * 0.014, 1e-9);
  EXPECT_EQ(made.raised().rise, 0.0);
}

TEST(RaisePeaks, ChanceMakesNoPeak) {
  const auto raisedBy = [](double bend) {
    Made made;
    made.at(1, 0) = made.at(1, 1) = 0.02, made.at(1, -1) = 0.02 - 2.0 * bend;
    return made.raised().max_deviation - 0.02;
  };
  EXPECT_EQ(raisedBy(0.0014), 0.0);
  EXPECT_GT(raisedBy(0.0016), 0.0);
}

TEST(RaisePeaks, WhereAStationBesideIsNotSeenNothingIsSaid) {
  Made made;
  made.at(1, 0) = made.at(1, 1) = 0.05, made.at(1, -1) = kUnknown;
  EXPECT_EQ(made.raised().max_deviation, 0.05);
  EXPECT_EQ(made.raised().sigma, 0.0003);
}

}  // namespace tank_datum::shell_peaks_test
