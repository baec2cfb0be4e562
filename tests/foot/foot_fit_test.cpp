#include "foot/foot_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "foot/foot_profile.h"
#include "support/made_clouds.h"

namespace tank_datum::foot_fit_test {

using made_clouds::uniform;

constexpr double kNoise = 0.0005;

/// A pad of 300 mm with a weld.
FootProfile padProfile() {
  FootProfile profile;
  profile.bin = 0.003;
  profile.band_from = 0.015, profile.band_to = profile.edge = 0.3;
  profile.blur = 0.006;
  profile.noise = kNoise;
  profile.surface = Surface::Foundation;
  return profile;
}

FootPrior priorOf(double slope = 0.0, double sigma_slope = 0.1, double sigma_bend = 0.003) {
  FootPrior prior;
  prior.slope = slope;
  prior.sigma_slope = sigma_slope;
  prior.sigma_bend = sigma_bend;
  return prior;
}

using Surface2 = std::function<double(double d, double t)>;

/// Points at random places of a window half a metre wide.
std::vector<FootPoint> pointsOn(const Surface2& height, int count, double noise = 0.0, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<FootPoint> points;
  for (int i = 0; i < count; ++i) {
    const double d = 0.3 * uniform(random), t = 0.5 * (uniform(random) - 0.5);
    points.push_back({t, d, height(d, t) + noise * normal(random)});
  }
  return points;
}

FootFit fitted(const std::vector<FootPoint>& points, const FootPrior& prior = priorOf()) {
  return fitFoundation(points, padProfile(), 2.0, prior);
}

TEST(FitFoot, OfAnExactPlaneIsItsElevationAtTheShell) {
  const FootFit fit = fitted(pointsOn([](double d, double t) { return 2.0 + 0.01 * d + 0.001 * t; }, 200));
  ASSERT_TRUE(fit.valid());
  EXPECT_NEAR(fit.z, 2.0, 2e-6);
  EXPECT_NEAR(fit.slope, 0.01, 2e-5);
  EXPECT_LT(fit.sigma, 5e-5);
  EXPECT_LT(fit.noise, 0.3 * kNoise);
}

TEST(FitFoot, OfABentDatumIsItsElevationInTheMiddle) {
  const auto bent = pointsOn([](double, double t) { return 2.0 + 0.01 * t * t; }, 200);
  EXPECT_NEAR(fitted(bent, priorOf(0, 0.1, 0.05)).z, 2.0, 1e-5);
  EXPECT_GT(fitted(bent, priorOf(0, 0.1, 1e-6)).z, 2.0001);  // told that the datum is straight
}

TEST(FitFoot, PointsThatShareAnErrorDoNotTellASlopeOrALevelBetterThanThat) {
  const auto sloped = pointsOn([](double d, double) { return 2.0 + 0.01 * d; }, 200, kNoise);
  FootPrior prior = priorOf(0.0, 0.003);
  EXPECT_NEAR(fitted(sloped, prior).slope, 0.01, 0.001);
  prior.shared = square(0.001);
  EXPECT_NEAR(fitted(sloped, prior).slope, 0.0, 0.002);
  prior.sigma_slope = prior.sigma_bend = 1e-6;
  EXPECT_NEAR(fitted(sloped, prior).sigma, 0.001, 0.0001);
}

/// What one row of a scan meets that crosses a rough pad, which falls by 0.03 m/m: rays that fall inwards by 0.1 m/m
/// meet its bumps farther out.
std::vector<FootPoint> rowAcross(double first_t, double last_t) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<FootPoint> points;
  for (double t = first_t; t < last_t; t += 0.05) {
    const double bump = 0.001 * normal(random), d = 0.15 + 0.1 * t + bump / 0.13;
    points.push_back({t, d, 2.0 - 0.03 * d + bump});
  }
  return points;
}

FootFit fittedAcross(const std::vector<FootPoint>& row, double scatter) {
  FootPrior prior = priorOf(-0.03, 0.005);
  prior.scatter = scatter;
  return fitted(row, prior);
}

TEST(FitFoot, OneRowDoesNotTellTheSlopeOfARoughSurface) {
  const auto across = rowAcross(-1.2, 1.2), aside = rowAcross(0.2, 1.4);
  EXPECT_GT(std::abs(fittedAcross(across, 0.0).z - 2.0), 0.001);
  EXPECT_NEAR(fittedAcross(across, 0.001).z, 2.0, 0.0004);
  EXPECT_NEAR(fittedAcross(across, 0.001).slope, -0.03, 0.002);
  EXPECT_LT(std::abs(fittedAcross(aside, 0.001).z - 2.0), 2.0 * fittedAcross(aside, 0.001).sigma);
}

TEST(FitFoot, PointsAllOverABandTellItsSlope) {
  FootPrior prior = priorOf();
  prior.scatter = 2.0 * kNoise;
  const FootFit fit = fitted(pointsOn([](double d, double t) { return 2.0 + 0.01 * d + 0.001 * t; }, 200), prior);
  EXPECT_NEAR(fit.slope, 0.01, 1e-4);
  EXPECT_LT(fit.sigma, 2e-4);
}

/// The fit of a level surface, 0.3 of a step above one, whose points were rounded and spread over the steps.
FootFit roundedTo(double step, double noise, double slope = 0.0) {
  FootPrior prior = priorOf(slope);
  prior.rounding.step = step;
  auto points = pointsOn([=](double d, double) { return 2.0 + 0.3 * step + slope * d; }, 2000, noise);
  std::mt19937_64 random(5);
  for (FootPoint& p : points) p.z = (std::round(p.z / step) + uniform(random) - 0.5) * step;
  return fitted(points, prior);
}

TEST(FitFoot, RoundingLeavesMoreUnknownThanPointsScatterBy) {
  constexpr double kStep = 0.001;
  const FootFit level = roundedTo(kStep, 0.0);
  EXPECT_NEAR(level.z, 2.0, 5e-5) << "off by 0.3 steps";
  EXPECT_NEAR(level.rounding, kStep / std::sqrt(12.0), 1e-5);
  EXPECT_GT(level.sigma, level.rounding);
  EXPECT_GT(level.sigma_slope, level.rounding / 0.1) << "alike for all: half of a band's points";
  EXPECT_LT(roundedTo(kStep, kStep).rounding, 0.01 * kStep) << "noise parts them";
  EXPECT_LT(roundedTo(kStep, 0.0, 0.02).rounding, 0.01 * kStep) << "as a slope does that is known";
  EXPECT_EQ(fitted(pointsOn([](double, double) { return 2.0; }, 200)).rounding, 0.0);
}

TEST(FitFoot, FewerThanFourPointsAreNotEnough) {
  const std::vector<FootPoint> three = {{0, 0.05, 2.0}, {0.1, 0.15, 2.0}, {0, 0.29, 2.0}, {0, 0.295, 2.0}};
  EXPECT_FALSE(fitted(three).valid());  // the last two are in the blur of where the surface ends
  EXPECT_TRUE(std::isnan(fitted(three).z));
  EXPECT_FALSE(fitted({}).valid());
}

TEST(FitFoot, UsesWhatIsInTheBandAndNearTheSurface) {
  std::vector<FootPoint> points = pointsOn([](double, double) { return 2.0; }, 300);
  const std::size_t used = fitted(points).points;
  EXPECT_GT(used, 250U);
  EXPECT_LT(used, 300U);
  for (int i = 0; i < 100; ++i) {
    points.push_back({0.0, 0.010, 2.005});  // weld
    points.push_back({0.0, 0.310, 2.005});  // beyond
    points.push_back({0.0, 0.100, 2.030});  // a thing lying there
    points.push_back({0.0, 0.100, 1.970});
  }
  const FootFit fit = fitted(points);
  EXPECT_EQ(fit.points, used);
  EXPECT_NEAR(fit.z, 2.0, 1e-6);
}

TEST(FitFoot, AShadowMovesTheEndOfTheSurface) {
  auto points = pointsOn([](double, double) { return 2.0; }, 400);
  points.erase(std::remove_if(points.begin(), points.end(), [](const FootPoint& p) { return p.d > 0.1; }),
               points.end());
  for (FootPoint& p : points) {
    if (p.d > 0.096) p.z -= 0.002;  // beams that straddle the shadow's edge
  }
  EXPECT_NEAR(fitted(points).z, 2.0, 1e-5);
}

TEST(FitFoot, WithFewPointsThePriorWinsAndSigmaSaysSo) {
  const std::vector<FootPoint> far = {{-0.1, 0.24, 2.0}, {0.1, 0.25, 2.0}, {-0.1, 0.26, 2.0},
                                      {0.1, 0.25, 2.0},  {0, 0.25, 2.0},   {0, 0.29, 2.0}};
  const FootFit told = fitted(far, priorOf(0.04, 0.002));
  EXPECT_NEAR(told.slope, 0.04, 0.003);
  EXPECT_NEAR(told.z, 2.0 - 0.25 * 0.04, 0.001);
  EXPECT_GT(told.sigma, 0.8 * 0.25 * 0.002);
  EXPECT_LT(told.sigma, 1.5 * 0.25 * 0.002);
  EXPECT_NEAR(told.sigma_slope, 0.002, 0.0002);
  EXPECT_GT(fitted(far, priorOf(0.04, 0.1)).sigma, 3.0 * told.sigma);
}

TEST(FitFoot, WithManyPointsTheDataWin) {
  const auto points = pointsOn([](double d, double) { return 2.0 + 0.02 * d; }, 2000, kNoise);
  const FootFit fit = fitted(points, priorOf(0.0, 0.01));
  EXPECT_NEAR(fit.slope, 0.02, 0.001);
  EXPECT_NEAR(fit.z, 2.0, 4.0 * fit.sigma);
  EXPECT_LT(fit.sigma, 0.00005);
  EXPECT_NEAR(fit.noise, kNoise, 0.1 * kNoise);
}

TEST(FitFoot, OutliersDoNotMoveIt) {
  auto points = pointsOn([](double, double) { return 2.0; }, 400, kNoise);
  for (std::size_t i = 0; i < points.size(); i += 4) points[i].z += 0.004;  // gravel
  const FootFit fit = fitted(points);
  EXPECT_NEAR(fit.z, 2.0, 0.0002);
  EXPECT_LT(fit.noise, 2.0 * kNoise);
}

TEST(FitFoot, SigmaIsTheSpreadOfRepeatedScans) {
  for (const int count : {25, 200}) {
    std::vector<double> sigmas, slope_sigmas;
    double squares = 0, slope_squares = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
      const FootFit fit = fitted(pointsOn([](double d, double) { return 2.0 + 0.01 * d; }, count, kNoise, seed));
      ASSERT_TRUE(fit.valid());
      squares += (fit.z - 2.0) * (fit.z - 2.0) / 300;
      slope_squares += (fit.slope - 0.01) * (fit.slope - 0.01) / 300;
      sigmas.push_back(fit.sigma);
      slope_sigmas.push_back(fit.sigma_slope);
    }
    EXPECT_NEAR(std::sqrt(squares) / median(sigmas), 1.0, 0.15) << count;
    EXPECT_NEAR(std::sqrt(slope_squares) / median(slope_sigmas), 1.0, 0.15) << count;
  }
}

/// One row of a grazing scan at a distance from the shell: range noise moves its points along the beam.
std::vector<FootPoint> rowAt(double distance, double spread, double beam_slope) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<FootPoint> points;
  for (int i = 0; i < 200; ++i) {
    const double along = spread * normal(random);
    points.push_back({0.5 * (uniform(random) - 0.5), distance + along, 2.0 + beam_slope * along});
  }
  return points;
}

TEST(FitFoot, ARowCutByTheBandIsLessSureThanItsNoise) {
  const FootFit cut = fitted(rowAt(0.017, 0.006, 0.08), priorOf(0.0, 0.003));
  ASSERT_TRUE(cut.valid());
  EXPECT_GT(cut.z - 2.0, 0.0001);  // only what the noise moved outwards, and so up, is in the band
  EXPECT_LT(cut.z - 2.0, 2.0 * cut.sigma);
  EXPECT_GT(cut.sigma, 2.0 * cut.noise / std::sqrt(static_cast<double>(cut.points)));
}

}  // namespace tank_datum::foot_fit_test
