#include "fit/surface_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/statistics.h"

namespace tank_datum::surface_rows_test {

/// Rows of a known surface, with noise; of every tenth one z is far off.
SurfaceRows rowsOf(const Eigen::Vector4d& surface, std::size_t count, double noise) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  std::normal_distribution<double> scatter(0.0, noise);
  SurfaceRows rows;
  rows.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double a = place(random), t = place(random);
    const double off = i % 10 == 9 ? 0.2 : noise > 0.0 ? scatter(random) : 0.0;
    rows.add(a, t, surface.dot(Eigen::Vector4d(1.0, a, t, t * t)) + off);
  }
  rows.close();
  return rows;
}

const Eigen::Vector4d kSurface(3.0, -0.02, 0.004, 0.01);

/// One by one, as the normal equations are written.
TEST(SurfaceRows, TheSumsAreThoseOfTheNormalEquations) {
  for (const std::size_t count : {1U, 3U, 4U, 5U, 8U, 9U, 103U}) {
    SurfaceRows rows = rowsOf(kSurface, count, 0.001);
    const Eigen::Vector4d other(2.999, 0.0, 0.0, 0.0);
    rows.residualsFrom(other);
    rows.weigh(0.01);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double weight = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = rows.t()[i], w = rows.weights()[i];
      const Eigen::Vector4d row(1.0, rows.a()[i], t, t * t);
      matrix += w * row * row.transpose();
      right += w * (rows.residuals()[i] + other.dot(row)) * row;
      weight += w;
    }
    const SurfaceRows::Equations equations = rows.equations();
    EXPECT_TRUE(equations.matrix.isApprox(matrix, 1e-12)) << count;
    EXPECT_TRUE(equations.right.isApprox(right, 1e-12)) << count;
    EXPECT_NEAR(equations.weight, weight, 1e-12) << count;
  }
}

TEST(SurfaceRows, WithoutNoiseGiveTheSurfaceBackExactly) {
  SurfaceRows rows = rowsOf(kSurface, 9, 0.0);
  const SurfaceRows::Equations e = rows.equations();
  EXPECT_LT((e.matrix.inverse() * e.right - kSurface).norm(), 1e-9);
  EXPECT_LT(rows.residualsFrom(kSurface), 1e-12);
}

TEST(SurfaceRows, WeightsAndSigmaAreThoseOfTheStatistics) {
  SurfaceRows rows = rowsOf(kSurface, 102, 0.001);
  const double sigma = rows.residualsFrom(kSurface);
  EXPECT_NEAR(sigma, robustSigma(rows.residuals(), 0.0), 1e-15);
  EXPECT_NEAR(sigma, 0.001, 0.0004);
  rows.weigh(sigma);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_NEAR(rows.weights()[i], tukeyWeight(rows.residuals()[i] / sigma), 1e-12) << i;
    EXPECT_EQ(rows.weights()[i] == 0.0, std::abs(rows.residuals()[i]) >= 4.685 * sigma) << i;
  }
}

TEST(FitRobustly, IsTheSurfaceOfTheRowsThatAreNotFarOff) {
  SurfaceRows rows = rowsOf(kSurface, 400, 0.001);
  const auto fit = fitRobustly(rows);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->noise, 0.001, 0.0002);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(fit->solution[k], kSurface[k], 4.0 * fit->noise * std::sqrt(fit->inverse(k, k)));
  EXPECT_TRUE((fit->normal * fit->inverse).isIdentity(1e-9));
  EXPECT_EQ(rows.weights()[9], 0.0);
}

TEST(FitRobustly, WhatTheRowsDoNotTellIsAsKnownBefore) {
  constexpr double kTurn = 0.05, kBend = 0.1;
  SurfaceRows rows;
  for (int i = 0; i < 40; ++i) rows.add(0.01 * i, 0.2, 3.0 + (i % 2 ? 0.001 : -0.001));
  rows.close();
  const auto fit = fitRobustly(rows, {{0.0, 0.0, 1.0 / (kTurn * kTurn), 1.0 / (kBend * kBend)}, 0.002});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->solution[0], 3.0, 1e-3);
  EXPECT_NEAR(fit->solution[2], 0.0, 1e-6);
  EXPECT_NEAR(fit->noise * std::sqrt(fit->inverse(0, 0)), std::hypot(0.2 * kTurn, 0.04 * kBend), 1e-4);
}

TEST(FitRobustly, OfRowsInOnePlaceThereIsNone) {
  SurfaceRows rows;
  for (int i = 0; i < 20; ++i) rows.add(0.1, 0.2, 3.0);
  rows.close();
  EXPECT_FALSE(fitRobustly(rows));
}

}  // namespace tank_datum::surface_rows_test
