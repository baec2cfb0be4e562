#include "locate/foot_heights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_heights_test {

constexpr std::size_t kSectors = 180;  // of 2 degrees
constexpr double kVoxel = 0.1;
constexpr FootWindow kWide = {1.0, 0.3};

double azimuthOf(std::size_t sector) { return toRadians(2.0 * static_cast<double>(sector) + 1.0); }

/// Feet over the first 20 sectors, risen by `slope` per radian from the middle.
double slopeOfArc(double slope) {
  std::vector<double> feet(kSectors, kUnknown);
  for (std::size_t i = 0; i < 20; ++i) feet[i] = slope * std::sin(azimuthOf(i) - toRadians(20.0));
  const PeriodicFit fit = fitFootHeights(feet, kVoxel, kWide);
  return (fit(toRadians(30.0)) - fit(toRadians(10.0))) / (slope * 2.0 * std::sin(toRadians(10.0)));
}

/// The ridge of 0.02 of the data's weight stands against the mean of sin^2 over the arc.
TEST(FitFootHeights, OfAShortArcTheSlopeIsDrawnToLevel) {
  double squares = 0.0;
  for (std::size_t i = 0; i < 20; ++i) squares += std::pow(std::sin(azimuthOf(i) - toRadians(20.0)), 2) / 20.0;
  EXPECT_NEAR(slopeOfArc(0.1), squares / (squares + 0.02), 0.04);  // the ends of the arc have less weight
}

TEST(FitFootHeights, ShellsThatEndAboveAShadowDoNotLiftTheFoot) {
  std::vector<double> feet;
  for (std::size_t i = 0; i < kSectors; ++i) feet.push_back(i % 3 == 0 ? 0.0 : 2.0);
  EXPECT_NEAR(fitFootHeights(feet, kVoxel, {0.5, 0.3})(1.0), 0.0, 1e-12);
}

TEST(FitFootHeights, OfNoFeetThereIsNone) {
  EXPECT_FALSE(fitFootHeights(std::vector<double>(kSectors, kUnknown), kVoxel, kWide).valid());
}

/// The fit in the middle of the first `low` sectors, in which every other foot is `rough` high, and `high` elsewhere.
double fitOverLowArc(std::size_t low, double high, double rough = 0.0) {
  std::vector<double> feet(kSectors, high);
  for (std::size_t i = 0; i < low; ++i) feet[i] = i % 2 == 0 ? 0.0 : rough;
  return fitFootHeights(feet, kVoxel, kWide)(azimuthOf(low / 2));
}

TEST(FitFootHeights, IsLoweredToHoldTheLowestArc) {
  EXPECT_NEAR(fitOverLowArc(20, 0.6), 0.3, 0.01);
  EXPECT_NEAR(fitOverLowArc(20, 0.9), 0.3, 0.01);
  EXPECT_GT(fitOverLowArc(20, 0.32), 0.27);  // is held as it is
}

TEST(FitFootHeights, AnArcHasThreeQuartersOf30DegreesThatAgree) {
  EXPECT_NEAR(fitOverLowArc(12, 0.6), 0.3, 0.01);
  EXPECT_GT(fitOverLowArc(11, 0.6), 0.5);
}

TEST(FitFootHeights, FeetAgreeWithinThreeVoxels) {
  EXPECT_NEAR(fitOverLowArc(31, 0.9, 0.27), 0.3, 0.03);
  EXPECT_GT(fitOverLowArc(31, 0.9, 0.33), 0.6);
}

}  // namespace tank_datum::foot_heights_test
