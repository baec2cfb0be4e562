#include "foot/ring_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum {
namespace {

constexpr double kError = 0.006, kLean = 0.05;
constexpr ExpectedSlope kLevel{0.0, 0.0, 0.0};

/// Standard error of the slopes of 72 windows, every third seen so steeply that beams feign nothing, which differ from
/// those of the ring by their errors times so much; of the others, times that.
double sigmaWhere(double best, double others) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<SeriesValue> seen, series;
  for (int k = 0; k < 72; ++k) {
    const bool steep = k % 3 == 0;
    seen.push_back({(steep ? best : others) * kError * normal(random), kError, 1.0});
    series.push_back(seen.back());
    if (!steep) series.back().sigma = std::hypot(kError, kLean);
  }
  std::vector<SeriesValue> smooth = series;
  drawTogether(seen, series, kLevel, smooth);
  return smooth.front().sigma;
}

TEST(DrawTogether, SlopesDifferByNoMoreThanAllOfThemShow) {
  EXPECT_LT(sigmaWhere(1.0, 1.0), 0.6 * kError);
  EXPECT_LT(sigmaWhere(2.0, 1.0), 0.6 * kError) << "few differ by chance";
  EXPECT_GT(sigmaWhere(2.0, 2.0), 0.8 * kError) << "all do";
}

TEST(DrawTogether, WhatBeamsFeignMakesNoSlopesDiffer) { EXPECT_LT(sigmaWhere(1.0, 6.0), 0.6 * kError); }

TEST(DrawTogether, SlopesThatDifferLittleMayDifferUnseen) {
  // half a standard error of their variance, of some seventy
  EXPECT_NEAR(sigmaWhere(0.2, 0.2), 0.2 * kError * std::sqrt(0.5 * std::sqrt(2.0 / 72.0)), 0.012 * kError);
}

TEST(DrawTogether, OfWhatBeamsMayFeignBesidesSixTenthsAreDoubted) {
  std::vector<SeriesValue> seen(72, {0.0, 1e-5, 1.0}), smooth = seen;
  const double sigma = drawTogether(seen, seen, {0.0, 1e-4, 0.0, 0.02}, smooth).sigma;
  EXPECT_NEAR(sigma, 1.0 / std::hypot(1.0 / 0.012, 1.0 / 0.03), 1e-5);
}

}  // namespace
}  // namespace tank_datum
