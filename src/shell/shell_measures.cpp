#include "shell/shell_measures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/plain_text.h"
#include "core/units.h"
#include "limits/checks.h"
#include "limits/survey_spacing.h"
#include "shell/shell_roundness.h"

namespace tank_datum {
namespace {

constexpr double kNearlyAll = 0.9;  // of the shell's height

Measure radiusMeasure(const Roundness& r) {
  Measure measure;
  measure.quantity = isAtFoot(r.height) ? "roundness_foot" : "roundness_above";
  measure.worst = {r.largest(), r.sigma, r.azimuth};
  measure.whole_ring = r.widest_gap <= kSurveySpacing;
  measure.note = formatted("%.2f m above the datum", r.height);
  return measure;
}

/// The widest arc in which the shell is nowhere seen over nearly all of its height [m].
double widestArcWithout(const std::vector<Plumbness>& plumbness, double height, double radius) {
  std::vector<double> directions;
  for (const Plumbness& p : plumbness) {
    if (p.height >= kNearlyAll * height) directions.push_back(p.direction);
  }
  if (directions.empty()) return kTwoPi * radius;
  std::sort(directions.begin(), directions.end());
  double widest = directions.front() + kTwoPi - directions.back();
  for (std::size_t i = 1; i < directions.size(); ++i) widest = std::max(widest, directions[i] - directions[i - 1]);
  return widest * radius;
}

/// Its own height where that is not said: the most that is seen of it [m].
double heightOf(const std::vector<Plumbness>& plumbness, const TankFacts& facts) {
  if (std::isfinite(facts.height)) return facts.height;
  double height = 0.0;
  for (const Plumbness& p : plumbness) height = std::max(height, p.height);
  return height;
}

}  // namespace

std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts, double radius) {
  std::vector<Measure> measures;
  if (const Roundness* foot = survey.foot()) measures.push_back(radiusMeasure(*foot));
  if (const Roundness* above = survey.worstAbove()) measures.push_back(radiusMeasure(*above));
  if (const Plumbness* plumb = survey.worstPlumbness()) {
    Measure measure;
    measure.quantity = "plumbness";
    measure.worst = {std::abs(plumb->offset), plumb->sigma, plumb->azimuth};
    measure.note = formatted("over %.1f m of height", plumb->height);
    const double height = heightOf(survey.plumbness, facts);
    measure.whole_ring =
        plumb->height >= kNearlyAll * height && widestArcWithout(survey.plumbness, height, radius) <= kSurveySpacing;
    measures.push_back(measure);
  }
  return measures;
}

std::vector<LimitComparison> compareRoundness(const ShellSurvey& survey, const std::vector<Limit>& limits,
                                              const TankFacts& facts, double diameter) {
  std::vector<LimitComparison> comparisons;
  for (const Roundness& r : survey.roundness) {
    comparisons.push_back(compare(limits, radiusMeasure(r), facts, diameter));
  }
  return comparisons;
}

}  // namespace tank_datum
