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

constexpr int kDegrees = 360;
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
  epoch.levelled = trial.levelled;
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal(0.0, trial.sigma * trial.scatter);
  std::array<double, kDegrees> white;
  for (double& value : white) value = normal(generator);
  const std::vector<double> kernel = kernelOf(trial);
  for (int station = 0; station < trial.stations; ++station) {
    const int i = station * kDegrees / trial.stations;
    const double a = i * kDegree, off = (i - kMiddle) / (0.5 * trial.dip_width_deg);
    double z = 0.006 * std::cos(2.0 * a) + 0.003 * std::sin(3.0 * a);
    for (std::size_t k = 0; k < kernel.size(); ++k)
      z += kernel[k] * white[(static_cast<std::size_t>(i) + k) % kDegrees];
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
  movement->add_option("--stations", trial.stations, "of a survey, evenly spaced")->check(CLI::Range(8, kDegrees));
  movement->add_option("--sigma", trial.sigma, "standard error of a station [m]")->check(CLI::PositiveNumber);
  movement->add_option("--scatter", trial.scatter, "actual errors over that")->check(CLI::PositiveNumber);
  movement->add_option("--window-deg", trial.window_deg, "arc that a station's points come from")
      ->check(CLI::Range(1.0, 90.0));
  movement->add_option("--correlated-deg", trial.correlated_deg, "arc within which errors are shared; 0: as said")
      ->check(CLI::Range(0.0, 90.0));
  movement->add_option("--remove", trial.remove, "what is taken from the movement")
      ->check(CLI::IsMember({"none", "mean", "tilt"}));
  movement->add_flag("--levelled", trial.levelled, "their errors are as people state them");
  movement->add_option("--dip", trial.dip, "depth [m]");
  movement->add_option("--dip-width-deg", trial.dip_width_deg, "whole width")->check(CLI::Range(1.0, 180.0));
  return movement;
}

MovementRates ratesOf(const MovementTrial& trial) {
  const auto count = static_cast<std::size_t>(trial.runs);
  MovementOptions options = trial.options;
  if (trial.remove != "none") options.removal = trial.remove == "mean" ? Removal::Mean : Removal::Tilt;
  std::vector<char> alarm(count), mean(count), tilt(count), rest(count), any(count), found(count), elsewhere(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    const Epoch before = surveyOf(trial, 3 * i, 0.0);
    const Movement still = compareEpochs(before, surveyOf(trial, 3 * i + 1, 0.0), options);
    const Movement moved = compareEpochs(before, surveyOf(trial, 3 * i + 2, trial.dip), options);
    alarm[i] = still.significant > 0;
    mean[i] = still.mean_significant;
    tilt[i] = still.tilt_significant;
    rest[i] = still.rest_significant;
    any[i] = still.moved();
    for (const StationMovement& s : moved.stations) {
      if (!s.significant) continue;
      const double off = std::abs(s.azimuth / kDegree - kMiddle);
      if (2 * off <= trial.dip_width_deg) found[i] = 1;
      if (off > trial.dip_width_deg) elsewhere[i] = 1;
    }
  });
  MovementRates rates;
  rates.runs = trial.runs;
  const auto those = [](const std::vector<char>& marks) {
    return static_cast<int>(std::count(marks.begin(), marks.end(), 1));
  };
  rates.alarms = those(alarm), rates.means = those(mean), rates.tilts = those(tilt);
  rates.rests = those(rest), rates.moved = those(any);
  rates.found = those(found), rates.elsewhere = those(elsewhere);
  return rates;
}

void print(const MovementTrial& trial, const MovementRates& rates) {
  const auto line = [&rates](const char* what, int count) {
    std::printf("%-38s %5d of %d  %6.2f %%\n", what, count, rates.runs, 100.0 * count / rates.runs);
  };
  std::printf("%d stations, sigma %.2f mm, errors %.2f of it, windows of %g deg, dip %.1f mm over %g deg\n",
              trial.stations, 1e3 * trial.sigma, trial.scatter, trial.window_deg, 1e3 * trial.dip, trial.dip_width_deg);
  line("unmoved: any significant station", rates.alarms);
  line("unmoved: mean settlement significant", rates.means);
  line("unmoved: change of tilt significant", rates.tilts);
  line("unmoved: out of plane significant", rates.rests);
  line("unmoved: moved, by any of these", rates.moved);
  line("dip: found", rates.found);
  line("dip: significant elsewhere too", rates.elsewhere);
}

}  // namespace tank_datum::rates
