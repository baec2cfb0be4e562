#include "shape_rates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <vector>

#include "core/normal95.h"
#include "core/parallel.h"
#include "core/units.h"
#include "shape/analysis.h"
#include "shape/deformation.h"
#include "shape/levelness.h"
#include "shape/second_differences.h"
#include "shape/settlement_arcs.h"
#include "stations/stations.h"

namespace tank_datum::rates {
namespace {

constexpr double kRadius = 30.0;
constexpr int kHighest = 15;  ///< of the waves: half-waves of 20 ft

using Waves = std::vector<double>;  ///< coefficients 1, a1, b1, a2, ...
AnalysisOptions optionsOf() {
  AnalysisOptions options;
  options.facts = {16.0, 235.0, 206000.0, "open", "ringwall", Service::InService};
  return options;
}

double heightAt(const Waves& waves, double azimuth) {
  double z = waves[0];
  for (int n = 1; n <= kHighest; ++n) {
    const auto at = static_cast<std::size_t>(2 * n - 1);
    z += waves[at] * std::cos(n * azimuth) + waves[at + 1] * std::sin(n * azimuth);
  }
  return z;
}

Waves drawnWaves(const ShapeTrial& trial, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> phase(0.0, kTwoPi);
  Waves waves(2 * kHighest + 1, 0.0);
  const auto put = [&](int n, double amplitude) {
    const double at = phase(generator);
    waves[static_cast<std::size_t>(2 * n - 1)] = amplitude * std::cos(at);
    waves[static_cast<std::size_t>(2 * n)] = amplitude * std::sin(at);
  };
  put(1, 0.006);
  if (trial.waves == "one") {
    put(trial.wave, 0.01);
  } else if (trial.waves == "few") {
    put(2, 0.008), put(3, 0.008), put(9, 0.003);
  } else {
    for (int n = 2; n <= kHighest; ++n) put(n, 0.008 * 4.0 / (n * n));
  }
  return waves;
}

std::vector<Station> stationsAt(const Waves& waves, int count) {
  StationOptions options;
  options.count = count;
  std::vector<Station> stations = emptyStations(options);
  for (Station& s : stations) {
    s.x = kRadius * std::cos(s.direction), s.y = kRadius * std::sin(s.direction);
    s.z = heightAt(waves, s.azimuth), s.radius = kRadius;
    s.flag = StationFlag::Measured;
  }
  return stations;
}

/// Errors of the stations: white, or means of white noise over an arc.
void disturb(std::vector<Station>& stations, const ShapeTrial& trial, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  const std::size_t count = stations.size();
  std::vector<double> white(count);
  for (double& w : white) w = normal(generator);
  const auto width = static_cast<std::size_t>(std::max(1.0, trial.correlated_deg / 360.0 * static_cast<double>(count)));
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < width; ++k) sum += white[(i + k) % count];
    stations[i].z += trial.sigma * sum / std::sqrt(static_cast<double>(width));
    if (trial.claimed > 0.0) stations[i].sigma_z = trial.sigma * trial.claimed;
    if (stations[i].azimuth < 100.0 * kDegree || stations[i].azimuth >= (100.0 + trial.gap_deg) * kDegree) continue;
    stations[i].z = stations[i].sigma_z = kUnknown;
    stations[i].flag = StationFlag::Missing;
  }
}

Analysis analysed(std::vector<Station>& stations, Tilt& tilt, const AnalysisOptions& options) {
  tilt = fitTilt(stations, {0.0, 0.0}, StationOptions());
  stations = withParts(stations, standingsTo(tilt, stations, {0.0, 0.0}));
  return analyse({stations, tilt, kRadius}, options);
}

/// Largest |curvature| of the waves round the ring [1/m].
double largestCurvature(const Waves& waves) {
  double largest = 0.0;
  for (int i = 0; i < 360; ++i) {
    double bend = 0.0;
    for (int n = 2; n <= kHighest; ++n) {
      const auto at = static_cast<std::size_t>(2 * n - 1);
      bend += n * n * (waves[at] * std::cos(n * i * kDegree) + waves[at + 1] * std::sin(n * i * kDegree));
    }
    largest = std::max(largest, std::abs(bend) / (kRadius * kRadius));
  }
  return largest;
}

const Check* checkOf(const std::vector<Check>& checks, const std::string& quantity) {
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& c) {
    return c.quantity == quantity && std::isfinite(c.limit) && c.role != "shown";
  });
  return found == checks.end() ? nullptr : &*found;
}

bool holds(const Interval95& interval, double truth) { return interval.low <= truth && truth <= interval.high; }

struct Run {
  bool tilt = false, curvature = false, u = false, s = false, level = false, wrong_fail = false;
  int waves = 0, all_waves = 0;
  Verdict verdict = Verdict::NotApplicable;
};

/// What is to be found.
struct Truth {
  Waves waves;
  std::map<std::string, double> figures;  ///< by quantity
  std::map<std::string, double> shares;   ///< of the limit
};

/// The figures of the waves themselves, at the stations.
Truth describedTruth(const Waves& waves, int count) {
  const TankFacts facts = optionsOf().facts;
  const double steel = facts.yield / facts.modulus / facts.height, diameter = 2.0 * kRadius;
  std::vector<Station> stations = stationsAt(waves, count);
  Truth truth{waves, {}, {}};
  double& u = truth.figures["u"];
  for (Station& s : stations) {
    s.u = s.u_fit = s.z - waves[0] - waves[1] * std::cos(s.azimuth) - waves[2] * std::sin(s.azimuth);
    u = std::max(u, std::abs(s.u));
  }
  const auto put = [&truth](const char* quantity, double value, double limit) {
    truth.figures[quantity] = value, truth.shares[quantity] = value / limit;
  };
  put("curvature", largestCurvature(waves), 11.0 * steel);
  const SecondDifferences d = secondDifferencesOf(stations, kRadius, 0);
  const double s = d.all.at(d.worst).value;
  put("second_difference", s, 5.5 * std::pow(d.spacings.at(d.worst), 2.0) * steel);
  put("neighbour_bend", s / d.spacing, 1.0 / 450.0);
  put("slope_10m", steepest(stations, kRadius, 10.0, &Station::z).value, 0.0025);
  put("level_9m", unevennessWithin(stations, kRadius, 9.0).value, 0.003);
  double share = 0.0;
  for (const SettlementArc& arc : settlementArcs(stations, kRadius)) {  // K = 3.6 of 54.9 to 73.2 m, open top
    const double limit = std::min(0.1016, 0.08333 * 3.6 * arc.length * diameter * steel);
    share = std::max(share, arc.largest.value / limit);
  }
  put("settlement_arc", share, 1.0);
  return truth;
}

Truth truthOf(const ShapeTrial& trial, std::mt19937_64& generator) {
  Waves waves = drawnWaves(trial, generator);
  if (trial.of_limit > 0.0) {
    const double scale = trial.of_limit / describedTruth(waves, trial.stations).shares.at(trial.figure);
    for (double& w : waves) w *= scale;
  }
  return describedTruth(waves, trial.stations);
}

Run oneRun(const ShapeTrial& trial, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const Truth truth = truthOf(trial, generator);
  std::vector<Station> stations = stationsAt(truth.waves, trial.stations);
  disturb(stations, trial, generator);
  Tilt tilt;
  const Analysis analysis = analysed(stations, tilt, optionsOf());
  Run run;
  const Eigen::Vector2d along = tilt.gradient.normalized();
  const double slope = along.dot(Eigen::Vector2d(truth.waves[1], truth.waves[2])) / kRadius;
  run.tilt = std::abs(tilt.slope() - slope) <= kNormal95 * tilt.sigma_slope;
  run.curvature = holds(analysis.out_of_plane.curvature_interval, truth.figures.at("curvature"));
  run.u = holds(analysis.out_of_plane.u_interval, truth.figures.at("u"));
  for (const auto& [quantity, held] : {std::pair("second_difference", &run.s), {"level_9m", &run.level}}) {
    const Check* check = checkOf(analysis.checks, quantity);
    *held = check && holds(check->interval, truth.figures.at(quantity));
  }
  for (const Harmonic& h : analysis.harmonics) {
    if (h.n < 2 || h.n > 6) continue;
    const auto at = static_cast<std::size_t>(2 * h.n - 1);
    const double phase = h.n * h.crest;
    const double amplitude = truth.waves[at] * std::cos(phase) + truth.waves[at + 1] * std::sin(phase);
    run.waves += std::abs(h.amplitude - amplitude) <= kNormal95 * h.sigma, ++run.all_waves;
  }
  for (const Check& c : analysis.checks) {
    if (c.verdict != Verdict::Fail) continue;
    const auto share = truth.shares.find(c.quantity);
    run.wrong_fail = run.wrong_fail || (share != truth.shares.end() && share->second <= 1.0 + 1e-9);
  }
  if (const Check* check = checkOf(analysis.checks, trial.figure)) run.verdict = check->verdict;
  return run;
}

}  // namespace

CLI::App* addShape(CLI::App& app, ShapeTrial& trial) {
  CLI::App* shape = app.add_subcommand("shape", "intervals and verdicts on the shape, of simulated surveys");
  shape->option_defaults()->always_capture_default();
  shape->add_option("--runs", trial.runs, "surveys")->check(CLI::PositiveNumber);
  shape->add_option("--stations", trial.stations, "round the tank")->check(CLI::Range(8, 3600));
  shape->add_option("--sigma", trial.sigma, "errors of a station [m]")->check(CLI::PositiveNumber);
  shape->add_option("--claimed", trial.claimed, "what the survey says of them, over that; 0: nothing")
      ->check(CLI::NonNegativeNumber);
  shape->add_option("--correlated-deg", trial.correlated_deg, "arc within which errors are shared")
      ->check(CLI::Range(0.0, 90.0));
  shape->add_option("--gap-deg", trial.gap_deg, "of the ring is not seen")->check(CLI::Range(0.0, 180.0));
  shape->add_option("--waves", trial.waves, "of the truth")->check(CLI::IsMember({"fall", "few", "one"}));
  shape->add_option("--wave", trial.wave, "number of the one wave")->check(CLI::Range(2, kHighest));
  shape->add_option("--of-limit", trial.of_limit, "the figure over its limit; 0: waves of 8 mm (2/n)^2");
  shape->add_option("--figure", trial.figure, "whose verdicts are counted")
      ->check(CLI::IsMember({"curvature", "second_difference", "settlement_arc", "level_9m", "slope_10m"}));
  return shape;
}

ShapeRates ratesOf(const ShapeTrial& trial) {
  std::vector<Run> runs(static_cast<std::size_t>(trial.runs));
  forEachIndex(runs.size(), 0, [&](std::size_t i) { runs[i] = oneRun(trial, i); });
  ShapeRates rates;
  rates.runs = trial.runs;
  for (const Run& run : runs) {
    rates.tilt += run.tilt, rates.curvature += run.curvature, rates.u += run.u, rates.s += run.s;
    rates.level += run.level, rates.wrong_fails += run.wrong_fail;
    rates.waves += run.waves, rates.all_waves += run.all_waves;
    rates.passed += run.verdict == Verdict::Pass, rates.failed += run.verdict == Verdict::Fail;
    rates.undecided += run.verdict == Verdict::Undecided;
  }
  return rates;
}

void print(const ShapeTrial& trial, const ShapeRates& r) {
  const auto share = [&](double count) { return 100.0 * count / r.runs; };
  std::printf("tilt %5.1f  waves %5.1f  curvature %5.1f  U %5.1f  S_i %5.1f  level %5.1f | ", share(r.tilt),
              100.0 * static_cast<double>(r.waves) / static_cast<double>(std::max(1L, r.all_waves)), share(r.curvature),
              share(r.u), share(r.s), share(r.level));
  std::printf("%s pass %5.1f fail %5.1f undecided %5.1f | any wrong fail %5.1f\n", trial.figure.c_str(),
              share(r.passed), share(r.failed), share(r.undecided), share(r.wrong_fails));
}

}  // namespace tank_datum::rates
