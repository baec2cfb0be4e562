#include "tank_datum/shape/analysis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/units.h"
#include "shape/levelness.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kWidestGap = 6.096;  // 20 ft [m]

Measure measureOf(const std::string& quantity, const PlacedValue& worst) {
  Measure measure;
  measure.quantity = quantity;
  measure.worst = worst;
  if (!std::isfinite(worst.value)) measure.unavailable = "too few stations have an elevation";
  return measure;
}

PlacedValue largestOf(const std::vector<PlacedValue>& values) {
  PlacedValue largest;
  for (const PlacedValue& v : values) {
    if (isLarger(largest, v)) largest = v;
  }
  return largest;
}

Measure secondDifferenceMeasure(const SecondDifferences& differences) {
  Measure measure = measureOf("second_difference", largestOf(differences.all));
  measure.all = differences.all;
  measure.spacing = differences.spacing;
  if (!differences.valid()) {
    measure.unavailable = differences.message;
    return measure;
  }
  char text[120];
  std::snprintf(text, sizeof text, "%d points %.2f m apart from %d start angle%s", differences.points,
                differences.spacing, differences.starts, differences.starts == 1 ? "" : "s");
  measure.note = text + (differences.message.empty() ? "" : "; " + differences.message);
  return measure;
}

Measure curvatureMeasure(const OutOfPlane& fit) {
  Measure measure = measureOf("curvature", {fit.max_curvature, fit.sigma_curvature, fit.max_curvature_azimuth});
  measure.unavailable = fit.message;
  if (fit.valid()) measure.note = "waves up to n = " + std::to_string(fit.order);
  return measure;
}

void addArcs(const std::vector<SettlementArc>& arcs, std::vector<Measure>& measures) {
  for (const SettlementArc& arc : arcs) {
    Measure measure = measureOf("settlement_arc", arc.largest);
    measure.arc = arc.length;
    char text[64];
    std::snprintf(text, sizeof text, "arc of %.1f m", arc.length);
    measure.note = text;
    measures.push_back(measure);
  }
  if (!arcs.empty()) return;
  measures.push_back(measureOf("settlement_arc", {}));
  measures.back().unavailable = "the out-of-plane settlement nowhere changes its sign";
}

void addTilt(const Tilt& tilt, double radius, std::vector<Measure>& measures) {
  const double slope = tilt.valid() ? tilt.slope() : kUnknown;
  const double diameter = 2.0 * radius;
  measures.push_back(measureOf("tilt_slope", {slope, tilt.sigma_slope, tilt.direction}));
  measures.push_back(measureOf("tilt_height", {diameter * slope, diameter * tilt.sigma_slope, tilt.direction}));
}

/// Differences of height along the shell.
void addSlopes(const std::vector<Station>& stations, double radius, double spacing, std::vector<Measure>& measures) {
  const bool spaced = std::isfinite(spacing);
  const char* not_spaced = "no survey points 15 to 32 ft apart";
  for (const auto& [quantity, member] :
       {std::pair<const char*, double Station::*>{"neighbour_bend", &Station::u}, {"neighbour_slope", &Station::z}}) {
    measures.push_back(measureOf(quantity, spaced ? steepest(stations, radius, spacing, member) : PlacedValue{}));
    if (!spaced) measures.back().unavailable = not_spaced;
  }
  measures.push_back(measureOf("slope_10m", steepest(stations, radius, 10.0, &Station::z)));
}

std::vector<std::string> notesOf(const std::vector<Station>& stations, const Tilt& tilt, const Analysis& analysis) {
  std::vector<std::string> notes = {
      "Screening for a storage-tank engineer, not a code evaluation.",
      "The levels of the instrument limit the tilt: an instrument out of level by some seconds of arc tilts every "
      "elevation alike. Out-of-plane settlement (n >= 2) is untouched by that.",
      "The antipodal inclination is an upper bound of the tilt: one station's error or bump counts in full."};
  if (tilt.r2 < 0.9) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "The tilt plane explains %.0f %% of the variance of the elevations; API 653 Annex B before 2024 asked "
        "for 90 %%.",
        100.0 * tilt.r2);
    notes.push_back(text);
  }
  if (analysis.longest_gap > kWidestGap && stations.size() > 64) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "A gap of %.1f m has no elevations: rules on the shape are undecided where they do not fail.",
                  analysis.longest_gap);
    notes.push_back(text);
  }
  if (std::none_of(stations.begin(), stations.end(), [](const Station& s) { return s.sigma_z > 0.0; })) {
    notes.push_back("The elevations have no standard errors: verdicts are by the values alone.");
  }
  return notes;
}

}  // namespace

std::string firstError(const AnalysisOptions& options) {
  const std::string error = firstError(options.facts);
  if (!error.empty()) return error;
  if (options.classic_points < 0) {
    return "analysis.classic_points = " + std::to_string(options.classic_points) + " (must be >= 0)";
  }
  return {};
}

Analysis analyse(std::vector<Station>& stations, const Tilt& tilt, double radius, const AnalysisOptions& options,
                 const std::vector<Measure>& shell) {
  Analysis result;
  result.harmonics = harmonicsOf(stations, radius);
  result.out_of_plane = fitOutOfPlane(stations, radius);
  result.second_differences = secondDifferencesOf(stations, radius, options.classic_points);
  result.arcs = settlementArcs(stations, radius);
  result.level_9m = unevennessWithin(stations, radius, 9.0);
  result.level_3m = unevennessWithin(stations, radius, 3.0);
  result.level_total = unevennessOfAll(stations);
  result.longest_gap = longestGap(stations, radius);

  std::vector<Measure>& measures = result.measures;
  measures.push_back(secondDifferenceMeasure(result.second_differences));
  measures.push_back(curvatureMeasure(result.out_of_plane));
  addArcs(result.arcs, measures);
  addSlopes(stations, radius, result.second_differences.spacing, measures);
  for (const auto& [quantity, level] : {std::pair("level_9m", result.level_9m), {"level_3m", result.level_3m}}) {
    measures.push_back(measureOf(quantity, level));
    if (!std::isfinite(level.value)) measures.back().unavailable = "no two stations are that close";
  }
  measures.push_back(measureOf("level_total", result.level_total));
  const double step = kTwoPi * radius / static_cast<double>(stations.size());
  for (Measure& m : measures) m.whole_ring = result.longest_gap <= std::max(kWidestGap, 1.01 * step);
  addTilt(tilt, radius, measures);
  measures.insert(measures.end(), shell.begin(), shell.end());
  result.checks = judge(options.limits, measures, options.facts, 2.0 * radius);
  result.notes = notesOf(stations, tilt, result);
  return result;
}

}  // namespace tank_datum
