#include "movement/limit_rates.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "movement/trend.h"
#include "tank_datum/core/error.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {
namespace {

constexpr double kInSight = 200.0;  ///< after the last survey [years]

/// value(t) = level + rate (t - at), with the variances of level and rate, which are independent.
struct Line {
  double at = 0.0, level = 0.0, rate = 0.0;
  double level_variance = 0.0, rate_variance = 0.0;
  double quantile2 = 0.0;  ///< square of the 95 % point of an error over its standard error
};

struct Observation {
  double time = 0.0, value = 0.0, sigma = 0.0;
};

/// @param seen  of two times or more
Line lineThrough(const std::vector<Observation>& seen) {
  Line line;
  double weights = 0.0, spread = 0.0, misfit = 0.0;
  const auto weight = [](const Observation& o) { return 1.0 / (o.sigma * o.sigma); };
  for (const Observation& o : seen) {
    weights += weight(o);
    line.at += weight(o) * o.time, line.level += weight(o) * o.value;
  }
  line.at /= weights, line.level /= weights;
  for (const Observation& o : seen) {
    spread += weight(o) * (o.time - line.at) * (o.time - line.at);
    line.rate += weight(o) * (o.time - line.at) * o.value;
  }
  line.rate /= spread;
  for (const Observation& o : seen) {
    misfit += weight(o) * square(o.value - line.level - line.rate * (o.time - line.at));
  }
  const LineScatter scatter = scatterAbout(misfit, static_cast<double>(seen.size()) - 2.0);
  line.level_variance = scatter.variance / weights, line.rate_variance = scatter.variance / spread;
  line.quantile2 = square(student95(scatter.freedom));
  return line;
}

/// The times within which the band of the line holds the limit, none before the last survey; latest NaN: without an
/// end.
void meetLimit(const Line& line, double last, LimitRate& rate) {
  const double gap = rate.check.limit - line.level;
  const double a = line.rate * line.rate - line.quantile2 * line.rate_variance;
  const double b = -2.0 * line.rate * gap;
  const double c = gap * gap - line.quantile2 * line.level_variance;
  if (a > 0.0 && line.rate < 0.0) {
    rate.approach = Approach::Away;
    return;
  }
  const double half = std::sqrt(std::max(b * b - 4.0 * a * c, 0.0));
  if (a > 0.0) {
    rate.approach = Approach::Reached;
    rate.expected = std::max(last, line.at + gap / line.rate);
    rate.earliest = line.at + (-b - half) / (2.0 * a);
    rate.latest = std::max(last, line.at + (-b + half) / (2.0 * a));
  } else {
    rate.approach = Approach::NotBefore;
    rate.earliest = c <= 0.0 ? last : line.at + (-b - half) / (2.0 * a);
  }
  rate.earliest = std::max(rate.earliest, last);
  if (rate.latest > last + kInSight) rate.latest = kUnknown;
  if (!(rate.earliest < last + kInSight)) {
    rate.approach = Approach::NotInSight;
    rate.expected = rate.earliest = rate.latest = kUnknown;
  }
}

bool counts(const Check& check) {
  const bool judged = check.role == "judged" || check.role == "governing" || check.role == "second opinion";
  return judged && std::isfinite(check.value) && check.sigma > 0.0 && std::isfinite(check.limit);
}

bool sameRule(const Check& a, const Check& b) {
  return a.code == b.code && a.clause == b.clause && a.name == b.name && a.unit == b.unit;
}

/// The figures that a rule judged over the surveys; of the last one at least.
std::optional<LimitRate> rateOf(const Check& now, const std::vector<Epoch>& surveys, const std::vector<double>& times) {
  std::vector<Observation> seen;
  for (std::size_t i = 0; i < surveys.size(); ++i) {
    const auto& checks = surveys[i].checks;
    const auto found =
        std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return sameRule(c, now) && counts(c); });
    if (found != checks.end()) seen.push_back({times[i], found->value, found->sigma});
  }
  if (seen.size() < 2) return std::nullopt;
  const Line line = lineThrough(seen);
  LimitRate rate;
  rate.check = now;
  rate.rate = line.rate, rate.sigma = std::sqrt(line.rate_variance);
  if (now.value > now.limit) {
    rate.approach = Approach::Beyond;
  } else {
    meetLimit(line, times.back(), rate);
  }
  return rate;
}

/// The surveys' dates in years; nothing where one has none that can be read.
std::optional<std::vector<double>> datesInYears(const std::vector<Epoch>& surveys) {
  std::vector<double> times;
  try {
    for (const Epoch& survey : surveys) times.push_back(yearOf(survey.date));
  } catch (const Error&) {
    return std::nullopt;
  }
  return times;
}

/// What is beyond its limit first, then by the dates from which limits may be reached.
bool isSooner(const LimitRate& a, const LimitRate& b) {
  const auto rank = [](const LimitRate& r) {
    return r.approach == Approach::NotBefore ? Approach::Reached : r.approach;
  };
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  if (a.earliest != b.earliest && std::isfinite(a.earliest)) return a.earliest < b.earliest;
  return a.check.value / a.check.limit > b.check.value / b.check.limit;
}

}  // namespace

const char* nameOf(Approach approach) {
  constexpr const char* kNames[] = {"beyond", "reached", "not_before", "not_in_sight", "away"};
  return kNames[static_cast<int>(approach)];
}

LimitRates limitRatesOf(const std::vector<Epoch>& surveys) {
  const auto times = datesInYears(surveys);
  if (!times) return {{}, "limit_rate.no_dates"};
  if (std::adjacent_find(times->begin(), times->end(), std::greater_equal<>()) != times->end()) {
    return {{}, "limit_rate.no_order"};
  }
  LimitRates found;
  for (const Check& check : surveys.empty() ? std::vector<Check>() : surveys.back().checks) {
    if (!counts(check)) continue;
    if (auto rate = rateOf(check, surveys, *times)) found.rates.push_back(std::move(*rate));
  }
  std::stable_sort(found.rates.begin(), found.rates.end(), isSooner);
  if (found.rates.empty()) found.none = "limit_rate.no_figures";
  return found;
}

std::string monthOf(double year) {
  constexpr double kRounding = 1e-6;  // half a minute
  const double whole = std::floor(year);
  int month = 1;
  while (month < 12 && yearOf(static_cast<int>(whole), month + 1, 1) <= year + kRounding) ++month;
  char text[24];
  snprintfPlain(text, sizeof text, "%04.0f-%02d", whole, month);
  return text;
}

}  // namespace tank_datum
