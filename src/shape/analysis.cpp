#include "shape/analysis.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/length_units.h"
#include "core/plain_text.h"
#include "core/statistics.h"
#include "core/units.h"
#include "limits/checks.h"
#include "limits/survey_spacing.h"
#include "shape/deformation.h"
#include "shape/figures.h"
#include "shape/out_of_plane.h"
#include "shape/ring_fits.h"
#include "shape/second_differences.h"
#include "shape/settlement_arcs.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

void addTilt(const Tilt& tilt, double radius, std::vector<Measure>& measures) {
  const double slope = tilt.valid() ? tilt.slope() : kUnknown;
  for (const auto& [quantity, length] : {std::pair("tilt_slope", 1.0), {"tilt_height", 2.0 * radius}}) {
    Measure measure;
    measure.quantity = quantity;
    measure.worst = {length * slope, length * tilt.sigma_slope, tilt.direction};
    measure.freedom = tilt.freedom;
    if (!std::isfinite(slope)) measure.unavailable = "too few stations have an elevation";
    measures.push_back(measure);
  }
}

/// The largest difference of height across a diameter.
void addAntipodal(const std::vector<Station>& stations, bool whole, std::vector<Measure>& measures) {
  const Antipodal across = antipodalOf(stations);
  Measure measure;
  measure.quantity = "antipodal";
  measure.worst = {across.max_h, across.sigma, across.azimuth};
  measure.whole_ring = whole;
  if (!std::isfinite(across.max_h)) measure.unavailable = "no two stations lie across a diameter";
  measures.push_back(measure);
}

/// The ovality of the shell's top, which settlement makes.
void addTopOvality(double radius, double height, Analysis& result) {
  const OutOfPlane& fit = result.out_of_plane;
  const double lever = radius * height;
  Measure measure;
  measure.quantity = "top_ovality";
  measure.worst = {lever * fit.max_curvature, lever * fit.sigma_curvature, fit.max_curvature_azimuth};
  measure.interval = {lever * fit.curvature_interval.low, lever * fit.curvature_interval.high};
  if (!fit.valid())
    measure.unavailable = fit.message;
  else if (!std::isfinite(height))
    measure.unavailable = "not given: shell height (option height)";
  else
    result.top_ovality = {measure.worst, measure.interval};
  result.measures.push_back(measure);
}

/// What the stations show of their errors, where it is not what they say.
std::string errorsNote(const RingModel& model) {
  constexpr double kMismatch = 1.5;
  const RingNoise& noise = model.noise();
  const double over = noise.repeatability;
  if (noise.is_overstated) {
    const double sigma = 1e3 * median({model.data().sigmas.begin(), model.data().sigmas.end()});
    return formatted(
        "Standard errors of %.1f mm (median) are over three times what the elevations depart from a plane by: are they "
        "right, and in the unit of the elevations?",
        sigma);
  }
  if (!model.data().sigmas_known || !model.dense() || (over <= kMismatch && over >= 1.0 / kMismatch)) return {};
  char text[280];
  snprintfPlain(text, sizeof text,
                over > 1.0 ? "The stations depart from the fitted waves by %.1f times their standard errors (sigma_z): "
                             "errors that neighbours share. The intervals allow for it."
                           : "The stations scatter by %.1f times their standard errors (sigma_z) only: what is given "
                             "is used.",
                over);
  return text;
}

std::vector<LocalSettlement> localSettlementsOf(const RingModel& model) {
  std::vector<LocalSettlement> all;
  for (const RingModel::Local& local : model.locals()) {
    const double azimuth = withinTurn(local.shape.centre);
    all.push_back({azimuth, 2.0 * local.shape.half_width, local.height, local.sigma});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.azimuth < b.azimuth; });
  return all;
}

/// Where the datum is known to lie lower than its neighbours say, by what is not known.
bool hasShellBelow(const Station& station) { return station.reason == Unmeasured::ShellBelow; }

template <typename Predicate>
std::size_t count(const std::vector<Station>& stations, const Predicate& is) {
  return static_cast<std::size_t>(std::count_if(stations.begin(), stations.end(), is));
}

/// A gap of many stations, or few stations too far apart.
std::string gapNote(const std::vector<Station>& stations, double gap, double widest) {
  constexpr double kRounding = 1e-6;
  if (gap <= widest + kRounding) return {};
  if (stations.size() > 64)
    return formatted("A gap of %.1f m has no elevations: rules on the shape are undecided where they do not fail.",
                     gap);
  return formatted(
      "Neighbouring elevations are up to %.1f m apart: beyond %.2f m (%.0f ft) rules on the shape are undecided where "
      "they do not fail.",
      gap, widest, widest / kMetresPerFoot);
}

std::vector<std::string> notesOf(const std::vector<Station>& stations, const SurveyedRing& ring,
                                 const Analysis& analysis) {
  std::vector<std::string> notes = {
      "Screening for a storage-tank engineer, not a code evaluation. Bottom and edge settlement are not covered.",
      "Elevations of a first survey are settlement only if the tank was built level.",
      "The levels of the instrument limit the tilt: an instrument out of level by some seconds of arc tilts every "
      "elevation alike. Out-of-plane settlement (n >= 2) is untouched by that.",
      "The antipodal inclination is an upper bound of the tilt: one station's error or bump counts in full."};
  if (ring.tilt.r2 < 0.9) {
    char text[240];
    snprintfPlain(
        text, sizeof text,
        "The tilt plane explains %.0f %% of the variance of the elevations; API 653 Annex B before 2024 asks for "
        "90 %%: its out-of-plane rule is not valid under that edition.",
        100.0 * ring.tilt.r2);
    notes.push_back(text);
  }
  const std::string gap = gapNote(stations, analysis.longest_gap, ring.widest_gap);
  if (!gap.empty()) notes.push_back(gap);
  if (const auto below = count(stations, hasShellBelow); below > 0) {
    char text[200];
    snprintfPlain(text, sizeof text,
                  "The shell is seen below the level that the neighbours give (stations: %zu): "
                  "rules on the shape are undecided where they do not fail.",
                  below);
    notes.push_back(text);
  }
  if (const auto doubted = count(stations, mayBeHeaved); doubted > 0) {
    char text[200];
    snprintfPlain(text, sizeof text,
                  "What was refused may be a heave of the foundation (stations: %zu): "
                  "the intervals of rules on the shape hold it.",
                  doubted);
    notes.push_back(text);
  }
  if (std::none_of(stations.begin(), stations.end(), [](const Station& s) { return s.sigma_z > 0.0; })) {
    notes.push_back(stations.size() > 64 ? "The elevations have no standard errors: what they scatter by is taken."
                                         : "The elevations have no standard errors, and so few stations do not tell "
                                           "shape from error: verdicts on the shape are by the values alone.");
  }
  return notes;
}

}  // namespace

Analysis analyse(const SurveyedRing& ring, const AnalysisOptions& options) {
  const double radius = ring.radius;
  Analysis result;
  const SimulatedSurveys surveys(ring.stations, radius, ring.covariance);
  result.harmonics = harmonicsOf(ring.stations, radius, surveys.model());
  result.out_of_plane = fitOutOfPlane(ring.stations, radius, surveys.model());
  result.local_settlements = localSettlementsOf(surveys.model());
  const std::vector<Station> stations = withParts(ring.stations, result.out_of_plane.stations);
  result.second_differences = secondDifferencesOf(stations, radius, options.classic_points);
  result.arcs = settlementArcs(stations, radius);
  result.longest_gap = longestGap(stations, radius);

  Figures figures(stations, radius, surveys);
  figures.addNeighbours(result.second_differences, planSurvey(stations, radius, options.classic_points));
  figures.addCurvature(result.out_of_plane);
  figures.addOutOfPlane(result.out_of_plane);
  figures.addArcs(result.arcs);
  figures.addLevels(result);
  result.measures = figures.all();
  addTopOvality(radius, options.facts.height, result);
  const bool whole = result.longest_gap <= ring.widest_gap + 1e-6 && count(stations, hasShellBelow) == 0;
  for (Measure& m : result.measures) m.whole_ring = whole;
  addTilt(ring.tilt, radius, result.measures);
  result.measures.insert(result.measures.end(), ring.shell.begin(), ring.shell.end());
  addAntipodal(stations, whole, result.measures);
  result.checks = judge(options.limits, result.measures, options.facts, {2.0 * radius, 2.0 * ring.sigma_radius});
  result.headline = headlineOf(result.checks, {surveys.model().dense(), whole && count(stations, isInDoubt) == 0});
  for (Measure& m : result.measures) m.share = nullptr;  // it refers to the simulated surveys
  result.notes = notesOf(stations, ring, result);
  const std::string errors = errorsNote(surveys.model());
  if (!errors.empty()) result.notes.push_back(errors);
  return result;
}

}  // namespace tank_datum
