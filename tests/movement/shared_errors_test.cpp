// Surveys whose stations share errors: setups that do not meet, what the removal leaves of them, trends after it.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "support/made_epochs.h"

namespace tank_datum::shared_errors_test {

using made_epochs::Survey;
using made_epochs::with;

/// A survey by setups that see an arc of the ring each and do not meet: each is off in height by itself.
Epoch aloneSetups(std::size_t setups, double error, unsigned seed) {
  Epoch epoch = with(&Survey::sigma, 0.0002, seed).epoch();
  std::mt19937_64 generator(7000 + seed);
  std::normal_distribution<double> normal;
  std::vector<double> heights;
  for (std::size_t s = 0; s < setups; ++s) heights.push_back(error * normal(generator));
  for (std::size_t i = 0; i < epoch.stations.size(); ++i) {
    Elevation& e = epoch.stations[i];
    const std::size_t setup = i * setups / epoch.stations.size();
    e.z += heights[setup];
    e.sigma_z = std::hypot(e.sigma_z, error);
    e.shared.assign(setups, 0.0);
    e.shared[setup] = error;
  }
  return epoch;
}

TEST(CompareEpochs, SetupsThatDoNotMeetRaiseNoFalseAlarmsBesideATilt) {
  MovementOptions options;
  options.removal = Removal::Tilt;
  int alarms = 0;
  for (unsigned run = 1; run <= 40; ++run) {
    alarms += compareEpochs(aloneSetups(3, 0.0015, run), aloneSetups(3, 0.0015, 500 + run), options).moved() ? 1 : 0;
  }
  EXPECT_LE(alarms, 6);  // binomial(40, 0.05) exceeds it once in 300
}

TEST(CompareEpochs, ASurveysPartOfAnErrorIsWhatTheRemovalLeavesOfIt) {
  const Epoch before = with(&Survey::lift, 0.0, 1).epoch();
  Epoch after = with(&Survey::lift, 0.0, 2).epoch(), off = before;
  for (Elevation& e : off.stations) e.sigma_z = std::hypot(e.sigma_z, 0.003), e.shared = {0.003};
  for (const auto& [removal, left] :
       {std::pair{Removal::Nothing, std::sqrt(0.0003 * 0.0003 + 0.003 * 0.003 + 0.0001 * 0.0001)},
        std::pair{Removal::Mean, 0.0003}}) {
    MovementOptions options;
    options.removal = removal;
    const Movement m = compareEpochs(off, after, options);
    ASSERT_EQ(m.errors_used, 1.0);
    EXPECT_NEAR(m.stations[50].sigma_baseline, left, 1e-6);
  }
}

TEST(HistoriesOf, NoTrendIsSignificantOfATankWhoseCommonHeightWasRemoved) {
  MovementOptions options;
  options.removal = Removal::Mean;
  int significant = 0;
  for (unsigned run = 1; run <= 20; ++run) {
    std::vector<Epoch> epochs;
    for (const unsigned k : {0U, 100U, 200U}) epochs.push_back(aloneSetups(1, 0.0015, run + k));
    const auto histories =
        historiesOf({compareEpochs(epochs[0], epochs[1], options), compareEpochs(epochs[0], epochs[2], options)},
                    {2020, 2021, 2030});
    for (const StationHistory& h : histories) ASSERT_GT(h.sigma_rate, 0.0);
    significant += std::any_of(histories.begin(), histories.end(), [](const auto& h) { return h.significant; }) ? 1 : 0;
  }
  EXPECT_LE(significant, 4);  // binomial(20, 0.05) exceeds it once in 400
}

TEST(CompareEpochs, WavesOfTheWholeRingThatFallWithTheirNumberAreMovement) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> phase(0.0, kTwoPi);
  for (const double falls : {1.0, 1.5, 2.0}) {
    const Epoch before = with(&Survey::sigma, 0.00017, 1).epoch();
    Epoch after = with(&Survey::sigma, 0.00017, 2).epoch();
    for (int n = 2; n <= 10; ++n) {
      const double turned = phase(generator);
      for (Elevation& e : after.stations) e.z += 0.004 * std::pow(2.0 / n, falls) * std::cos(n * e.azimuth + turned);
    }
    const Movement m = compareEpochs(before, after, {});
    EXPECT_LE(m.errors_used, 4.0);
    EXPECT_TRUE(m.rest_significant) << falls;
    EXPECT_GT(m.significant, 20U) << falls;
  }
}

TEST(CompareEpochs, AnAzimuthOffsetIsAsUncertainAsSharedErrorsMakeIt) {
  MovementOptions options;
  options.estimate_offset = true;
  double squares = 0.0;
  constexpr unsigned kRuns = 24;
  for (unsigned run = 1; run <= kRuns; ++run) {
    const Movement m = compareEpochs(aloneSetups(5, 0.0006, run), aloneSetups(5, 0.0006, 500 + run), options);
    squares += std::pow(m.azimuth_offset / m.sigma_azimuth_offset, 2);
  }
  EXPECT_GT(squares, 0.4 * kRuns);  // chi-square of 24: one in a thousand is beyond either
  EXPECT_LT(squares, 2.15 * kRuns);
}

}  // namespace tank_datum::shared_errors_test
