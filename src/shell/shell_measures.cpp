#include "shell/shell_measures.h"

#include <cmath>

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

}  // namespace

std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts) {
  std::vector<Measure> measures;
  if (const Roundness* foot = survey.foot()) measures.push_back(radiusMeasure(*foot));
  if (const Roundness* above = survey.worstAbove()) measures.push_back(radiusMeasure(*above));
  if (const Plumbness* plumb = survey.worstPlumbness()) {
    Measure measure;
    measure.quantity = "plumbness";
    measure.worst = {std::abs(plumb->offset), plumb->sigma, plumb->azimuth};
    measure.note = formatted("over %.1f m of height", plumb->height);
    measure.whole_ring = !(plumb->height < kNearlyAll * facts.height);
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
