#include "limits/checks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clauses.h"
#include "core/normal95.h"
#include "core/plain_text.h"
#include "core/statistics.h"
#include "limits/limit_tables.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

std::map<char, double> letters(const Measure& measure, const TankFacts& facts, double diameter) {
  std::map<char, double> all = {{'D', diameter},      {'H', facts.height},    {'Y', facts.yield},
                                {'E', facts.modulus}, {'L', measure.spacing}, {'S', measure.arc}};
  for (auto it = all.begin(); it != all.end();) it = std::isfinite(it->second) ? std::next(it) : all.erase(it);
  return all;
}

double limitAt(const Limit& limit, const Measure& measure, const TankFacts& facts, double diameter) {
  const auto value = limit.formula.at(letters(measure, facts, diameter));
  return value ? std::min(*value, limit.at_most) : kUnknown;
}

std::string whatIsNotGiven(const Limit& limit, const TankFacts& facts) {
  std::string names;
  const auto lacks = [&](char letter, double value, const char* name) {
    if (limit.formula.powers.count(letter) == 0 || std::isfinite(value)) return;
    names += (names.empty() ? "" : ", ") + std::string(name);
  };
  lacks('H', facts.height, "shell height (option height)");
  lacks('Y', facts.yield, "yield strength (option yield_mpa)");
  lacks('E', facts.modulus, "elastic modulus (option modulus_mpa)");
  return names.empty() ? names : "not given: " + names;
}

/// The interval of a figure, which is a size: simulated, or from its standard error.
Interval95 intervalOf(const Measure& measure) {
  if (measure.interval.known() || !std::isfinite(measure.worst.sigma)) return measure.interval;
  const double half = student95(measure.freedom) * measure.worst.sigma;
  return {std::max(0.0, measure.worst.value - half), measure.worst.value + half};
}

/// The one rule by which a figure passes or fails.
/// @param interval  of the value, 95 %; not known where the errors are not
Verdict verdictOf(double value, Interval95 interval, double limit, bool whole_ring) {
  if (!std::isfinite(limit)) return Verdict::NotEvaluated;
  if (!interval.known()) interval = {value, value};
  if (interval.low > limit) return Verdict::Fail;
  if (interval.high > limit || value > limit || !whole_ring) return Verdict::Undecided;
  return Verdict::Pass;
}

/// A standard error whose 95 % reach the further end of the interval.
double sigmaOf(const Check& check) {
  return std::max(check.interval.high - check.value, check.value - check.interval.low) / kNormal95;
}

std::string shareBeyond(const Measure& measure, double limit) {
  if (measure.all.empty() || !std::isfinite(limit)) return {};
  const auto beyond =
      std::count_if(measure.all.begin(), measure.all.end(), [limit](const PlacedValue& v) { return v.value > limit; });
  char text[80];
  snprintfPlain(text, sizeof text, "%.0f %% of %zu values exceed the limit",
                100.0 * static_cast<double>(beyond) / static_cast<double>(measure.all.size()), measure.all.size());
  return text;
}

/// The figure that comes nearest to its limit, or goes furthest beyond.
const Measure& worstOf(const std::vector<const Measure*>& candidates, const Limit& limit, const TankFacts& facts,
                       double diameter) {
  const auto share = [&](const Measure* m) { return m->worst.value / limitAt(limit, *m, facts, diameter); };
  return **std::max_element(candidates.begin(), candidates.end(), [&](const Measure* a, const Measure* b) {
    return std::isfinite(share(a)) && std::isfinite(share(b)) ? share(a) < share(b) : a->worst.value < b->worst.value;
  });
}

/// Takes the verdict from a rule that is only shown, or is for tanks of another service.
Check standing(Check check, const Limit& limit, const TankFacts& facts) {
  check.role = "judged";
  if (!limit.judged) {
    check.role = "shown";
    addClause(check.note, "shown beside the limits that are judged by");
  } else if (!limit.service.empty() && limit.service != nameOf(facts.service)) {
    check.role = "for comparison";
    addClause(check.note, "for comparison: a rule for " + limit.service + " tanks");
  }
  if (check.role != "judged") check.verdict = Verdict::NotApplicable;
  return check;
}

/// A check without a figure, as its table names it.
Check namedAs(const Limit& first) {
  Check check;
  check.code = first.code;
  check.clause = first.clause;
  check.name = first.name;
  check.quantity = first.quantity;
  check.unit = first.unit;
  check.trust = first.trust;
  check.citation = first.citation;
  return check;
}

void takeFigure(const Measure& measure, Check& check) {
  check.value = measure.worst.value;
  check.interval = intervalOf(measure);
  check.sigma = measure.interval.known() ? sigmaOf(check) : measure.worst.sigma;
  check.azimuth = measure.worst.azimuth;
}

/// The limit for the figure, and the interval where that goes with the limit.
void takeLimit(const Limit& limit, const Measure& measure, const TankFacts& facts, double diameter, Check& check) {
  check.trust = limit.trust;
  check.citation = limit.citation;
  check.limit = limitAt(limit, measure, facts, diameter);
  if (!measure.share || !std::isfinite(check.limit)) return;
  const auto at_arc = [&](double arc) {
    Measure other = measure;
    other.arc = arc;
    return limitAt(limit, other, facts, diameter);
  };
  const Interval95 shares = measure.share(at_arc);
  check.interval = {check.limit * shares.low, check.limit * shares.high};
  check.sigma = sigmaOf(check);
}

/// A check whose figure and limit are known.
Check judged(Check check, const Limit& limit, const Measure& measure, const TankFacts& facts) {
  addClause(check.note, whatIsNotGiven(limit, facts));
  check.verdict = verdictOf(check.value, check.interval, check.limit, measure.whole_ring);
  check = standing(std::move(check), limit, facts);
  addClause(check.note, shareBeyond(measure, check.limit));
  if (check.verdict == Verdict::Undecided) {
    const bool hidden = !measure.whole_ring && !(check.interval.high > check.limit);
    addClause(check.note, hidden ? "what was not measured could be worse" : "the limit lies within the 95 % interval");
  }
  if (check.interval.known() && check.value > check.interval.high) {
    addClause(check.note, "errors of the survey raise the figure above its interval");
  }
  if (check.interval.known() && check.value < check.interval.low) {
    addClause(check.note, "the figure smooths local settlement that its interval holds");
  }
  addClause(check.note, measure.note);
  return check;
}

Check checkOf(const LimitTable& table, const std::vector<Measure>& measures, const TankFacts& facts, double diameter) {
  const Limit& first = *table.front();
  Check check = namedAs(first);
  std::vector<const Measure*> candidates;
  for (const Measure& m : measures) {
    if (m.quantity == first.quantity) candidates.push_back(&m);
  }
  const Limit* limit = rowFor(table, facts, diameter, check.note);
  if (candidates.empty()) {
    check.note = "the survey does not hold it";
    check.verdict = Verdict::NotEvaluated;
    return standing(check, first, facts);
  }
  const Measure& measure = worstOf(candidates, limit ? *limit : first, facts, diameter);
  takeFigure(measure, check);
  if (!measure.unavailable.empty()) {
    check.note = measure.unavailable;
    return standing(check, first, facts);
  }
  if (!limit) {
    check.verdict = check.note == kNoLimit ? Verdict::NotApplicable : Verdict::NotEvaluated;
    return standing(check, first, facts);
  }
  takeLimit(*limit, measure, facts, diameter, check);
  return judged(std::move(check), *limit, measure, facts);
}

}  // namespace

const char* nameOf(Service service) {
  return service == Service::New ? "new" : service == Service::Rebuilt ? "rebuilt" : "in-service";
}

std::vector<Check> judge(const std::vector<Limit>& limits, const std::vector<Measure>& measures, const TankFacts& facts,
                         double diameter) {
  std::vector<Check> checks;
  for (const LimitTable& table : tablesOf(limits)) checks.push_back(checkOf(table, measures, facts, diameter));
  return checks;
}

LimitComparison compare(const std::vector<Limit>& limits, const Measure& measure, const TankFacts& facts,
                        double diameter) {
  for (const LimitTable& table : tablesOf(limits)) {
    std::string reason;
    const Limit* limit = table.front()->quantity == measure.quantity ? rowFor(table, facts, diameter, reason) : nullptr;
    if (!limit) continue;
    const double at = limitAt(*limit, measure, facts, diameter);
    const bool is_other = !limit->service.empty() && limit->service != nameOf(facts.service);
    return {at, verdictOf(measure.worst.value, intervalOf(measure), at, measure.whole_ring),
            is_other ? limit->service : ""};
  }
  return {};
}

}  // namespace tank_datum
