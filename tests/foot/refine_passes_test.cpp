#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/refine.h"

namespace tank_datum {
namespace {

constexpr double kRadius = 5.0, kNoise = 0.0005;

double wave(double azimuth) { return 0.010 * std::cos(8.0 * azimuth); }

/// A shell upon a pad that waves, of which each degree has few points.
Ring wavingRing(int shell, int pad) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any;
  Ring ring;
  ring.reach = 0.5;
  const auto add = [&](double r, double height) {
    const double a = kTwoPi * any(random);
    ring.points.push_back({r * std::cos(a), r * std::sin(a), wave(a) + height});
  };
  for (int i = 0; i < shell; ++i) add(kRadius + kNoise * normal(random), 0.5 * any(random));
  for (int i = 0; i < pad; ++i) add(kRadius + 0.3 * any(random), kNoise * normal(random));
  return ring;
}

TEST(RefineStations, TheSectionIsAsSharpAsItsPointsThoughTheFirstLookSmoothsTheDatum) {
  Tank tank;
  tank.circle = {{0.0, 0.0}, kRadius};
  tank.foot.coefficients = Eigen::Vector3d::Zero();
  const RefinedFoot found = refineStations(wavingRing(20'000, 1'400), tank, {}, {});
  EXPECT_NEAR(found.refined.profile.noise, kNoise, 0.2 * kNoise);
}

}  // namespace
}  // namespace tank_datum
