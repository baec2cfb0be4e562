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

/// Of checks by the limits of classes one of which is the tank's, that by the strictest; undecided where they do not
/// agree.
/// @param classes  as many as checks, or more: some have no limit
Check strictestOf(const std::vector<Check>& checks, std::size_t classes) {
  Check check =
      *std::min_element(checks.begin(), checks.end(), [](const Check& a, const Check& b) { return a.limit < b.limit; });
  if (classes == 1) return check;
  addClause(check.note, "the diameter may be of either of two classes: by the stricter limit");
  const auto all = [&](Verdict verdict) {
    return std::all_of(checks.begin(), checks.end(), [&](const Check& c) { return c.verdict == verdict; });
  };
  const bool fails = all(Verdict::Fail) && checks.size() == classes;
  if (!fails && !all(Verdict::Pass) && check.role == "judged") check.verdict = Verdict::Undecided;
  return check;
}

Check checkOf(const LimitTable& table, const std::vector<Measure>& measures, const TankFacts& facts,
              const Diameter& diameter) {
  const Limit& first = *table.front();
  const Check named = namedAs(first);
  std::vector<const Measure*> candidates;
  for (const Measure& m : measures) {
    if (m.quantity == first.quantity) candidates.push_back(&m);
  }
  const auto without = [&](Check check, const std::string& why, Verdict verdict) {
    check.note = why;
    check.verdict = verdict;
    return standing(std::move(check), first, facts);
  };
  if (candidates.empty()) return without(named, "the survey does not hold it", Verdict::NotEvaluated);
  std::string reason;
  std::vector<const Limit*> rows = rowsFor(table, facts, diameter, reason);
  const std::size_t classes = rows.size();
  rows.erase(std::remove(rows.begin(), rows.end(), nullptr), rows.end());
  const Measure& measure = worstOf(candidates, rows.empty() ? first : *rows.front(), facts, diameter.value);
  Check figure = named;
  takeFigure(measure, figure);
  if (!measure.unavailable.empty()) return without(figure, measure.unavailable, Verdict::NotApplicable);
  if (rows.empty()) {
    return without(figure, reason, reason == kNoLimit ? Verdict::NotApplicable : Verdict::NotEvaluated);
  }
  std::vector<Check> checks;
  for (const Limit* limit : rows) {
    Check check = figure;
    takeLimit(*limit, measure, facts, diameter.value, check);
    checks.push_back(judged(std::move(check), *limit, measure, facts));
  }
  return strictestOf(checks, classes);
}

}  // namespace

const char* nameOf(Service service) {
  return service == Service::New ? "new" : service == Service::Rebuilt ? "rebuilt" : "in-service";
}

std::vector<Check> judge(const std::vector<Limit>& limits, const std::vector<Measure>& measures, const TankFacts& facts,
                         const Diameter& diameter) {
  std::vector<Check> checks;
  for (const LimitTable& table : tablesOf(limits)) checks.push_back(checkOf(table, measures, facts, diameter));
  return checks;
}

LimitComparison compare(const std::vector<Limit>& limits, const Measure& measure, const TankFacts& facts,
                        const Diameter& diameter) {
  LimitComparison other;
  for (const LimitTable& table : tablesOf(limits)) {
    if (table.front()->quantity != measure.quantity) continue;
    const Check check = checkOf(table, {measure}, facts, diameter);
    if (!std::isfinite(check.limit)) continue;
    if (check.role == "judged") return {check.limit, check.verdict, ""};
    if (check.role == "for comparison" && !std::isfinite(other.limit)) {
      other = {check.limit, check.verdict, table.front()->service};
    }
  }
  return other;
}

}  // namespace tank_datum
