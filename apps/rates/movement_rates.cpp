#include "movement_rates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "core/parallel.h"
#include "core/units.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum::rates {
namespace {

constexpr int kStations = 360;
constexpr int kMiddle = 100;  ///< of the dip [deg]

/// What one station's error takes from the white noise around it.
std::vector<double> kernelOf(const MovementTrial& trial) {
  std::vector<double> kernel = {0.03, 0.26, 1.0, 0.26, 0.03};
  const double shared = trial.correlated_deg > 0.0 ? trial.correlated_deg : trial.window_deg;
  if (shared > 3.0) kernel.assign(static_cast<std::size_t>(std::lround(shared)), 1.0);
  double squares = 0.0;
  for (const double k : kernel) squares += k * k;
  for (double& k : kernel) k /= std::sqrt(squares);
  return kernel;
}

/// A survey: its shape, its errors, and the dip as a raised cosine.
Epoch surveyOf(const MovementTrial& trial, std::uint64_t seed, double dip) {
  Epoch epoch{"survey", "ok", "refined", "foundation", {{0.0, 0.0}, 30.0}, {}};
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, trial.sigma * trial.scatter);
  std::array<double, kStations> white;
  for (double& value : white) value = normal(generator);
  const std::vector<double> kernel = kernelOf(trial);
  for (int i = 0; i < kStations; ++i) {
    const double a = i * kDegree, off = (i - kMiddle) / (0.5 * trial.dip_width_deg);
    double z = 0.006 * std::cos(2.0 * a) + 0.003 * std::sin(3.0 * a);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      z += kernel[k] * white[(static_cast<std::size_t>(i) + k) % kStations];
    if (std::abs(off) < 1.0) z -= dip * 0.5 * (1.0 + std::cos(180.0 * kDegree * off));
    epoch.stations.push_back({a, a, z, trial.sigma, trial.window_deg * kDegree});
  }
  return epoch;
}

}  // namespace

CLI::App* addMovement(CLI::App& app, MovementTrial& trial) {
  CLI::App* movement =
      app.add_subcommand("movement", "false alarms on unmoved tanks, and dips found, of simulated surveys");
  movement->option_defaults()->always_capture_default();
  movement->add_option("--runs", trial.runs, "pairs of surveys")->check(CLI::PositiveNumber);
  movement->add_option("--sigma", trial.sigma, "standard error of a station [m]")->check(CLI::PositiveNumber);
  movement->add_option("--scatter", trial.scatter, "actual errors over that")->check(CLI::PositiveNumber);
  movement->add_option("--window-deg", trial.window_deg, "arc that a station's points come from")
      ->check(CLI::Range(1.0, 90.0));
  movement->add_option("--correlated-deg", trial.correlated_deg, "arc within which errors are shared; 0: as said")
      ->check(CLI::Range(0.0, 90.0));
  movement->add_option("--remove", trial.remove, "what is taken from the movement")
      ->check(CLI::IsMember({"none", "mean", "tilt"}));
  movement->add_option("--dip", trial.dip, "depth [m]");
  movement->add_option("--dip-width-deg", trial.dip_width_deg, "whole width")->check(CLI::Range(1.0, 180.0));
  return movement;
}

MovementRates ratesOf(const MovementTrial& trial) {
  const auto count = static_cast<std::size_t>(trial.runs);
  MovementOptions options = trial.options;
  if (trial.remove != "none") options.removal = trial.remove == "mean" ? Removal::Mean : Removal::Tilt;
  std::vector<char> alarm(count), found(count), elsewhere(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    const Epoch before = surveyOf(trial, 3 * i, 0.0);
    const Movement still = compareEpochs(before, surveyOf(trial, 3 * i + 1, 0.0), options);
    const Movement moved = compareEpochs(before, surveyOf(trial, 3 * i + 2, trial.dip), options);
    alarm[i] = still.significant > 0;
    for (int s = 0; s < kStations; ++s) {
      if (!moved.stations[static_cast<std::size_t>(s)].significant) continue;
      const int off = std::abs(s - kMiddle);
      if (2 * off <= trial.dip_width_deg) found[i] = 1;
      if (off > trial.dip_width_deg) elsewhere[i] = 1;
    }
  });
  MovementRates rates;
  rates.runs = trial.runs;
  rates.alarms = static_cast<int>(std::count(alarm.begin(), alarm.end(), 1));
  rates.found = static_cast<int>(std::count(found.begin(), found.end(), 1));
  rates.elsewhere = static_cast<int>(std::count(elsewhere.begin(), elsewhere.end(), 1));
  return rates;
}

void print(const MovementTrial& trial, const MovementRates& rates) {
  const auto line = [&rates](const char* what, int count) {
    std::printf("%-34s %5d of %d  %6.2f %%\n", what, count, rates.runs, 100.0 * count / rates.runs);
  };
  std::printf("360 stations, sigma %.2f mm, errors %.2f of it, windows of %g deg, dip %.1f mm over %g deg\n",
              1e3 * trial.sigma, trial.scatter, trial.window_deg, 1e3 * trial.dip, trial.dip_width_deg);
  line("unmoved: any significant station", rates.alarms);
  line("dip: found", rates.found);
  line("dip: significant elsewhere too", rates.elsewhere);
}

}  // namespace tank_datum::rates
