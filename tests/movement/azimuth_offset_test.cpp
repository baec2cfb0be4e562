#include "movement/azimuth_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"

namespace tank_datum::azimuth_offset_test {

/// A wave of the datum round the ring.
struct Wave {
  int count;
  double amplitude;  ///< [m]
  double phase = 0.0;
};

constexpr double kSigma = 0.0003;  // [m]

/// A survey of a 15 m tank whose azimuths count from elsewhere by `turn`.
Epoch survey(const std::vector<Wave>& waves, double turn, unsigned seed = 0) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  Epoch epoch{"survey", "ok", "refined", "annular_plate", {{0.0, 0.0}, 15.0}, {}};
  for (int i = 0; i < 360; ++i) {
    const double direction = i * kDegree;
    Elevation e{direction, direction, 0.0, kSigma, 1.5 * kDegree};
    for (const Wave& w : waves) e.z += w.amplitude * std::cos(w.count * (direction + turn) + w.phase);
    if (seed > 0) e.z += kSigma * normal(generator);
    epoch.stations.push_back(e);
  }
  return epoch;
}

AzimuthOffset offsetBetween(const Epoch& baseline, const Epoch& current) {
  MovementOptions options;
  options.estimate_offset = true;
  return estimateOffset(baseline, current, options);
}

/// Standard error where one wave has moved.
double sigmaWith(const Wave& moved) {
  return offsetBetween(survey({{3, 0.005}, {2, 0.004}}, 0.0), survey({{3, 0.005}, {2, 0.004}, moved}, 0.0)).sigma;
}

TEST(EstimateOffset, AWaveThatMovedMayHaveMovedInAnyPhaseOfTheSlopes) {
  // a wave of slope s holds 1/2 s^2 of information a station, a moved wave of amplitude a brings a^2/2 of variance
  const double slopes = 0.5 * (std::pow(3 * 0.005, 2) + std::pow(2 * 0.004, 2)), moved = 0.002;
  const double expected = std::sqrt(std::pow(moved, 2) / 4.0 / slopes);
  EXPECT_NEAR(sigmaWith({7, moved, 0.4}) / expected, 1.0, 0.02);
  EXPECT_NEAR(sigmaWith({12, moved, 0.4}) / expected, 1.0, 0.02);
  EXPECT_LT(sigmaWith({13, moved, 0.4}) / expected, 0.5);
}

TEST(EstimateOffset, OfTanksThatMovedTheStandardErrorHolds) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  double squares = 0.0;
  constexpr unsigned kRuns = 40;
  for (unsigned run = 1; run <= kRuns; ++run) {
    std::vector<Wave> shape, moved;
    for (int n = 2; n <= 5; ++n)
      shape.push_back({n, (0.2 + 0.8 * unit(generator)) * 0.01 / n, kTwoPi * unit(generator)});
    moved = shape;
    for (int n = 2; n <= 7; ++n) moved.push_back({n, 0.0015 * normal(generator) / n, kTwoPi * unit(generator)});
    const double turn = kTwoPi * unit(generator);
    const AzimuthOffset found = offsetBetween(survey(shape, 0.0, run), survey(moved, turn, 500 + run));
    squares += std::pow(std::remainder(found.value - turn, kTwoPi) / found.sigma, 2.0);
  }
  EXPECT_LT(squares, 1.75 * kRuns);  // chi-square of 40: one in a thousand is beyond 73.4
  EXPECT_GT(squares, 0.3 * kRuns);
}

TEST(FitsTurned, SaysSoOfSurveysThatCountFromOtherMarks) {
  const std::vector<Wave> shape{{2, 0.004}, {3, 0.003, 1.0}};
  const auto fits = [&](double turn, const MovementOptions& options) {
    return compareEpochs(survey(shape, 0.0, 1), survey(shape, turn, 2), options).fits_turned;
  };
  EXPECT_TRUE(fits(kPi, {}));
  EXPECT_TRUE(fits(11.0 * kDegree, {}));
  EXPECT_FALSE(fits(9.0 * kDegree, {}));
  EXPECT_FALSE(fits(0.0, {}));
  MovementOptions estimated, given;
  estimated.estimate_offset = true, given.azimuth_offset = 0.1;
  EXPECT_FALSE(fits(kPi, estimated));
  EXPECT_FALSE(fits(kPi, given));
  std::vector<Wave> moved = shape;  // in its own frame
  moved.push_back({2, 0.004, 2.0});
  const Movement m = compareEpochs(survey(shape, 0.0, 1), survey(moved, 0.0, 2), {});
  EXPECT_TRUE(m.rest_significant);
  EXPECT_FALSE(m.fits_turned);
}

}  // namespace tank_datum::azimuth_offset_test
