#include "foot/ring_slope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/portable_math.h"
#include "core/units.h"

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

/// Weight of a wave of the slopes of 72 windows whose standard errors are as large, where so many of them are known.
double weightOfWave(int waves, std::size_t known, double errors) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<SeriesValue> seen, smooth;
  const auto wave = [waves](std::size_t k) {
    return kError * std::cos(waves * kTwoPi * static_cast<double>(k) / 72.0);
  };
  for (std::size_t k = 0; k < 72; ++k) {
    const bool is_known = k < known;
    seen.push_back({is_known ? wave(k) + errors * kError * normal(random) : NAN, is_known ? kError : NAN, 1.0});
    smooth.push_back({wave(k), 0.3 * kError, 1.0});
  }
  drawTogether(seen, seen, kLevel, smooth);
  double sum = 0.0, all = 0.0;
  for (std::size_t k = 0; k < 72; ++k) sum += smooth[k].value * wave(k), all += wave(k) * wave(k);
  return sum / all;
}

/// Weight of the slopes of 72 windows of a level lip, a quarter of which seem as steep as that, by soil.
double weightBesideSoil(double steep) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<SeriesValue> seen, smooth;
  for (int k = 0; k < 72; ++k) {
    seen.push_back({kError * normal(random) - (k % 36 < 9 ? steep : 0.0), kError, 1.0});
    smooth.push_back({kError, 0.3 * kError, 1.0});
  }
  drawTogether(seen, seen, kLevel, smooth);
  return square(smooth.front().sigma / (0.3 * kError));
}

TEST(DrawTogether, SoilThatNeighboursShareIsNoSlopeOfALip) {
  EXPECT_LT(weightBesideSoil(0.12), 0.95);
  EXPECT_GT(weightBesideSoil(0.08), 0.97);
}

TEST(DrawTogether, SlopesDifferByWhatNeighboursShare) {
  EXPECT_GT(weightOfWave(3, 72, 0.8), 0.75);  // of 1 / (1 + 2 * 0.09); by their scatter they may not differ at all
  EXPECT_LT(weightOfWave(18, 72, 0.8), 0.6);  // neighbours are a quarter of a wave apart
  EXPECT_LT(weightOfWave(3, 8, 0.0), 0.6);    // so few may share it by chance
}

TEST(DrawTogether, OfWhatBeamsMayFeignBesidesSixTenthsAreDoubted) {
  std::vector<SeriesValue> seen(72, {0.0, 1e-5, 1.0}), smooth = seen;
  const double sigma = drawTogether(seen, seen, {0.0, 1e-4, 0.0, 0.02}, smooth).sigma;
  EXPECT_NEAR(sigma, 1.0 / std::hypot(1.0 / 0.012, 1.0 / 0.03), 1e-5);
}

}  // namespace
}  // namespace tank_datum
