#include "tank_datum/limits/checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/clauses.h"
#include "core/statistics.h"
#include "tank_datum/core/normal95.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

using Table = std::vector<const Limit*>;
const char* const kNoLimit = "the rule has no limit for such a tank";

std::vector<Table> tablesOf(const std::vector<Limit>& limits) {
  std::vector<Table> tables;
  for (const Limit& limit : limits) {
    const auto same = std::find_if(tables.begin(), tables.end(), [&](const Table& table) {
      const Limit& first = *table.front();
      return first.code == limit.code && first.clause == limit.clause && first.name == limit.name;
    });
    (same == tables.end() ? tables.emplace_back() : *same).push_back(&limit);
  }
  return tables;
}

/// The row for this tank, or why there is none.
const Limit* rowFor(const Table& table, const TankFacts& facts, double diameter, std::string& reason) {
  bool roof_needed = false, foundation_needed = false;
  for (const Limit* limit : table) {
    if (!limit->diameter.holds(diameter)) continue;
    const bool roof = limit->roof.empty() || limit->roof == facts.roof;
    const bool foundation = limit->foundation.empty() || limit->foundation == facts.foundation;
    if (roof && foundation) return limit;
    roof_needed = roof_needed || (!roof && facts.roof.empty());
    foundation_needed = foundation_needed || (!foundation && facts.foundation.empty());
  }
  if (roof_needed) addClause(reason, "the type of roof is not given (option roof: open or fixed)");
  if (foundation_needed)
    addClause(reason, "the kind of foundation is not given (option foundation: ringwall or earth)");
  if (reason.empty()) reason = kNoLimit;
  return nullptr;
}

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

/// The interval of a figure: simulated, or from its standard error.
Interval95 intervalOf(const Measure& measure) {
  if (measure.interval.known() || !std::isfinite(measure.worst.sigma)) return measure.interval;
  const double half = student95(measure.freedom) * measure.worst.sigma;
  return {measure.worst.value - half, measure.worst.value + half};
}

Verdict verdictOf(const Check& check, bool whole_ring) {
  const Interval95 interval = check.interval.known() ? check.interval : Interval95{check.value, check.value};
  if (interval.low > check.limit) return Verdict::Fail;
  if (interval.high > check.limit || check.value > check.limit || !whole_ring) return Verdict::Undecided;
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
  std::snprintf(text, sizeof text, "%.0f %% of %zu values exceed the limit",
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

Check checkOf(const Table& table, const std::vector<Measure>& measures, const TankFacts& facts, double diameter) {
  const Limit& first = *table.front();
  Check check;
  check.code = first.code;
  check.clause = first.clause;
  check.name = first.name;
  check.quantity = first.quantity;
  check.unit = first.unit;
  check.trust = first.trust;
  check.citation = first.citation;
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
  check.value = measure.worst.value;
  check.interval = intervalOf(measure);
  check.sigma = measure.interval.known() ? sigmaOf(check) : measure.worst.sigma;
  check.azimuth = measure.worst.azimuth;
  if (!measure.unavailable.empty()) {
    check.note = measure.unavailable;
    return standing(check, first, facts);
  }
  if (!limit) {
    check.verdict = check.note == kNoLimit ? Verdict::NotApplicable : Verdict::NotEvaluated;
    return standing(check, first, facts);
  }
  check.trust = limit->trust;
  check.citation = limit->citation;
  check.limit = limitAt(*limit, measure, facts, diameter);
  if (measure.share && std::isfinite(check.limit)) {
    const auto at_arc = [&](double arc) {
      Measure other = measure;
      other.arc = arc;
      return limitAt(*limit, other, facts, diameter);
    };
    const Interval95 shares = measure.share(at_arc);
    check.interval = {check.limit * shares.low, check.limit * shares.high};
    check.sigma = sigmaOf(check);
  }
  addClause(check.note, whatIsNotGiven(*limit, facts));
  check.verdict = std::isfinite(check.limit) ? verdictOf(check, measure.whole_ring) : Verdict::NotEvaluated;
  check = standing(check, *limit, facts);
  addClause(check.note, shareBeyond(measure, check.limit));
  if (check.verdict == Verdict::Undecided) {
    const bool hidden = !measure.whole_ring && !(check.interval.high > check.limit);
    addClause(check.note, hidden ? "what was not seen could be worse" : "the limit lies within the 95 % interval");
  }
  addClause(check.note, measure.note);
  return check;
}

}  // namespace

const char* nameOf(Service service) {
  return service == Service::New ? "new" : service == Service::Rebuilt ? "rebuilt" : "in-service";
}

std::vector<Check> judge(const std::vector<Limit>& limits, const std::vector<Measure>& measures, const TankFacts& facts,
                         double diameter) {
  std::vector<Check> checks;
  for (const Table& table : tablesOf(limits)) checks.push_back(checkOf(table, measures, facts, diameter));
  return checks;
}

}  // namespace tank_datum
