#include "shell/shell_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/azimuth.h"
#include "core/clauses.h"
#include "core/normal95.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "limits/checks.h"
#include "limits/survey_spacing.h"
#include "shell/shell_roundness.h"

namespace tank_datum {
namespace {

constexpr double kNearlyAll = 0.9;   // of the shell's height
constexpr double kNextHeight = 0.5;  // that the shell is looked at, at most [m]
constexpr double kCourse = 3.0;      // plates are no higher [m]

/// What the largest deviation at a height may be: surely no less than at a place that was looked at, and more between
/// those.
Interval95 radiusInterval(const Roundness& r) {
  const double half = kNormal95 * std::sqrt(std::max(0.0, square(r.sigma) - square(r.rise)));
  const double high = r.largest() + half + std::max(r.may_rise, kNormal95 * r.rise);
  return {std::max(0.0, r.largest() - r.rise - half), std::max(high, r.doubted)};
}

Measure radiusMeasure(const Roundness& r) {
  Measure measure;
  measure.quantity = isAtFoot(r.height) ? "roundness_foot" : "roundness_above";
  measure.worst = {r.largest(), r.sigma, r.azimuth};
  measure.interval = radiusInterval(r);
  measure.whole_ring = r.widest_gap <= kSurveySpacing;
  measure.note = formatted("%.2f m above the datum", r.height);
  return measure;
}

/// What the shell of a tank is looked at over [m].
struct ShellSpan {
  double from, height;  ///< the lowest height that is seen, and the tank's own
};

/// Whether a height is nearly that of the shell: up to where the next one is above its rim, of a low tank.
bool isNearlyTop(double top, double height) { return top >= std::min(kNearlyAll * height, height - kNextHeight); }

/// Whether the shell is seen here from nearly its foot up to nearly its top: the offset of a place in a dent from one
/// above or below it is not the shell's.
bool isSeenWhole(const Plumbness& p, const ShellSpan& span) {
  return isNearlyTop(p.top, span.height) && p.height >= kNearlyAll * (p.top - span.from);
}

/// The widest arc in which the shell is nowhere seen over nearly all of its height [m].
double widestArcWithout(const std::vector<Plumbness>& plumbness, const ShellSpan& span, double radius) {
  std::vector<double> directions;
  for (const Plumbness& p : plumbness) {
    if (isSeenWhole(p, span)) directions.push_back(p.direction);
  }
  return widestArc(std::move(directions)) * radius;
}

/// Its own height where that is not said: the most that is seen of it [m].
double heightOf(const std::vector<Plumbness>& plumbness, const TankFacts& facts) {
  if (std::isfinite(facts.height)) return facts.height;
  double height = 0.0;
  for (const Plumbness& p : plumbness) height = std::max(height, p.top);
  return height;
}

ShellSpan spanOf(const std::vector<Plumbness>& plumbness, const TankFacts& facts) {
  double from = kUnknown;
  for (const Plumbness& p : plumbness) from = std::fmin(from, p.top - p.height);
  return {from, heightOf(plumbness, facts)};
}

/// Up to which height the shell is seen all round [m], at heights no farther apart than a course of plates is high.
double seenAllRoundTo(const std::vector<Roundness>& roundness) {
  double top = 0.0;
  for (const Roundness& r : roundness) {
    if (r.height > top + kCourse) break;
    if (r.widest_gap <= kSurveySpacing) top = r.height;
  }
  return top;
}

/// The largest deviation above the foot, of a whole ring where the shell is seen round the tank up to nearly its
/// height.
Measure radiusAbove(const ShellSurvey& survey, const Roundness& worst, double height) {
  Measure measure = radiusMeasure(worst);
  for (const auto* rows : {&survey.roundness, &survey.arcs}) {
    for (const Roundness& r : *rows) {
      if (!isAtFoot(r.height)) measure.interval.high = std::max(measure.interval.high, radiusInterval(r).high);
    }
  }
  const double top = seenAllRoundTo(survey.roundness);
  const bool is_arc = std::any_of(survey.arcs.begin(), survey.arcs.end(), [&](const auto& r) { return &r == &worst; });
  measure.whole_ring = (measure.whole_ring || is_arc) && isNearlyTop(top, height);
  if (!isNearlyTop(top, height)) addClause(measure.note, formatted("seen all round up to %.1f m", top));
  return measure;
}

/// What the largest offset between foot and top may be: as much more than what was seen as the shell goes on above it,
/// at the worst place and wherever nearly all was seen. Where much of it was not seen, a bulge may end there, and
/// surely is only what the whole tank leans by.
Interval95 plumbnessInterval(const ShellSurvey& survey, const Plumbness& worst, const ShellSpan& span) {
  const auto half = [](const Plumbness& p) { return kNormal95 * p.sigma; };
  const auto may_be = [&](const Plumbness& p) {
    return (std::abs(p.offset) + half(p)) * std::max(1.0, span.height / p.height);
  };
  double high = may_be(worst);
  for (const Plumbness& p : survey.plumbness) {
    if (isSeenWhole(p, span)) high = std::max(high, may_be(p));
  }
  const Lean& lean = survey.lean;
  const double leans = lean.valid() ? worst.height * (lean.slope() - kNormal95 * lean.sigma) : 0.0;
  const double low = std::abs(worst.offset) - half(worst);
  return {std::max(0.0, isSeenWhole(worst, span) ? low : std::min(low, leans)), high};
}

}  // namespace

std::vector<Measure> shellMeasures(const ShellSurvey& survey, const TankFacts& facts, double radius) {
  std::vector<Measure> measures;
  if (const Roundness* foot = survey.foot()) measures.push_back(radiusMeasure(*foot));
  const ShellSpan span = spanOf(survey.plumbness, facts);
  if (const Roundness* above = survey.worstAbove()) measures.push_back(radiusAbove(survey, *above, span.height));
  if (const Plumbness* plumb = survey.worstPlumbness()) {
    Measure measure;
    measure.quantity = "plumbness";
    measure.worst = {std::abs(plumb->offset), plumb->sigma, plumb->azimuth};
    measure.interval = plumbnessInterval(survey, *plumb, span);
    measure.note = formatted("over %.1f m of height", plumb->height);
    measure.whole_ring =
        isSeenWhole(*plumb, span) && widestArcWithout(survey.plumbness, span, radius) <= kSurveySpacing;
    measures.push_back(measure);
  }
  return measures;
}

std::vector<LimitComparison> compareRoundness(const ShellSurvey& survey, const std::vector<Limit>& limits,
                                              const TankFacts& facts, const Diameter& diameter) {
  std::vector<LimitComparison> comparisons;
  for (const Roundness& r : survey.roundness) {
    comparisons.push_back(compare(limits, radiusMeasure(r), facts, diameter));
  }
  return comparisons;
}

}  // namespace tank_datum
