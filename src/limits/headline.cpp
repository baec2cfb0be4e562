#include <algorithm>
#include <array>
#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "limits/checks.h"

namespace tank_datum {
namespace {

/// The rules on out-of-plane settlement, the one to govern first.
using Ranking = std::array<const char*, 3>;

bool isEvaluated(const Check& check) {
  return check.verdict == Verdict::Pass || check.verdict == Verdict::Fail || check.verdict == Verdict::Undecided;
}

void giveRoles(std::vector<Check>& checks, const Ranking& ranking) {
  const auto judged = [&](const char* quantity) {
    return std::find_if(checks.begin(), checks.end(),
                        [&](const Check& c) { return c.quantity == quantity && c.role == "judged"; });
  };
  auto governing = checks.end();
  for (const char* quantity : ranking) {
    const auto found = judged(quantity);
    if (found == checks.end()) continue;
    if (governing == checks.end() || (!isEvaluated(*governing) && isEvaluated(*found))) governing = found;
  }
  for (const char* quantity : ranking) {
    for (auto found = judged(quantity); found != checks.end(); found = judged(quantity)) found->role = "second opinion";
  }
  if (governing != checks.end()) governing->role = "governing";
}

double utilisationOf(const Check& check) { return check.value / check.limit; }

/// The check that a word rests on: the furthest beyond its limit, or nearest to it.
const Check* worst(const std::vector<Check>& checks, Verdict verdict) {
  const Check* found = nullptr;
  for (const Check& c : checks) {
    if (c.verdict != verdict || (c.role != "judged" && c.role != "governing")) continue;
    if (!found || utilisationOf(c) > utilisationOf(*found)) found = &c;
  }
  return found;
}

/// Whether an undecided figure is so near its limit that errors alone reach it. What was not measured widens an
/// interval upwards only.
bool isNear(const Headline& headline, bool whole) {
  const Interval95& interval = headline.utilisation_interval;
  if (headline.utilisation > 1.0) return true;
  const double by_errors = 2.0 * headline.utilisation - interval.low;
  return interval.known() && interval.high > 1.0 && (whole || by_errors > 1.0);
}

/// The report finds its words in other languages by these.
std::string meaningOf(const Headline& headline, const Check& check, bool whole) {
  if (headline.word == "INCOMPLETE") return " is not evaluated: " + check.note;
  const bool known = headline.utilisation_interval.known();
  if (headline.word == "FAIL") return known ? ", beyond it with 95 % confidence" : ", beyond it; errors are not known";
  if (headline.word == "PASS") return known ? ", the nearest of all" : ", the nearest of all; errors are not known";
  return isNear(headline, whole) ? ", too near it to decide" : "; what was not measured could be worse";
}

std::string sentenceOf(const Headline& headline, const Check* check) {
  const char* screening = "Screening for a storage-tank engineer, not a code evaluation.";
  if (!check) return "No rule could be judged. " + std::string(screening);
  std::string share;
  if (headline.word != "INCOMPLETE") {
    share = " is at " + shareOfLimit(headline);
    if (std::isfinite(check->azimuth)) {
      share += " at " + fixedText(std::fmod(std::round(toDegrees(check->azimuth)), 360.0), 0) + " deg";
    }
  }
  return headline.governing + share + headline.meaning + ". " + screening;
}

}  // namespace

std::string shareOfLimit(const Headline& headline) {
  const auto percent = [](double part) {  // on its own side of the limit
    const std::string text = fixedText(100.0 * part, 0);
    if (text != "100" || part == 1.0) return text;
    return fixedText((part < 1.0 ? std::floor(1e4 * part) : std::ceil(1e4 * part)) / 1e2, 2);
  };
  const std::string share = percent(headline.utilisation) + " % of its limit";
  const Interval95& interval = headline.utilisation_interval;
  if (!interval.known()) return share;
  return share + " (95 %: " + percent(interval.low) + " to " + percent(interval.high) + " %)";
}

Headline headlineOf(std::vector<Check>& checks, const RingSurveyed& ring) {
  giveRoles(checks, ring.dense ? Ranking{"curvature", "settlement_arc", "second_difference"}
                               : Ranking{"settlement_arc", "second_difference", "curvature"});
  Headline headline;
  const Check* check = nullptr;
  for (const auto& [verdict, word] : {std::pair(Verdict::Fail, "FAIL"),
                                      {Verdict::Undecided, "UNDECIDED"},
                                      {Verdict::NotEvaluated, "INCOMPLETE"},
                                      {Verdict::Pass, "PASS"}}) {
    check = worst(checks, verdict);
    if (!check) continue;
    headline.word = word;
    headline.governing = check->code + ' ' + check->name;
    if (std::isfinite(check->limit)) {
      headline.utilisation = utilisationOf(*check);
      headline.utilisation_interval = {check->interval.low / check->limit, check->interval.high / check->limit};
    }
    headline.meaning = meaningOf(headline, *check, ring.whole);
    break;
  }
  headline.sentence = sentenceOf(headline, check);
  return headline;
}

}  // namespace tank_datum
