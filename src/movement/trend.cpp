#include "movement/trend.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/azimuth.h"
#include "core/normal95.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "movement/epoch_matching.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

std::vector<StationMovement> byDirection(const Movement& movement) {
  std::vector<StationMovement> known;
  for (StationMovement s : movement.stations) {
    s.direction = withinTurn(s.direction);
    known.push_back(s);
  }
  std::sort(known.begin(), known.end(), [](const auto& a, const auto& b) { return a.direction < b.direction; });
  return known;
}

/// The movement at a direction: that of a station there, seen or not; else between two neighbours that were seen.
StationMovement movementAt(const std::vector<StationMovement>& known, double direction) {
  if (known.empty()) return {};
  const auto after = std::upper_bound(known.begin(), known.end(), direction + kSamePlace,
                                      [](double value, const StationMovement& s) { return value < s.direction; });
  const StationMovement& a = after == known.begin() ? known.back() : *(after - 1);
  const StationMovement& b = after == known.end() ? known.front() : *after;
  const double width = withinTurn(b.direction - a.direction), along = std::remainder(direction - a.direction, kTwoPi);
  if (std::abs(along) <= kSamePlace) return a;
  if (width > kWidestBracket + kSamePlace || !std::isfinite(a.dz) || !std::isfinite(b.dz)) return {};
  const double share = along / width;
  const auto between = [share](double from, double to) { return (1.0 - share) * from + share * to; };
  StationMovement at = share < 0.5 ? a : b;
  at.dz = between(a.dz, b.dz), at.sigma = between(a.sigma, b.sigma);  // neighbours share points
  at.sigma_baseline = between(a.sigma_baseline, b.sigma_baseline);
  return at;
}

/// Ordinary least squares. The slope is the same of z and of z less the baseline's, whose error counts once.
void fitRate(StationHistory& history, const std::vector<double>& times) {
  std::vector<std::size_t> seen;
  double mean = times.front(), baseline = 0.0;
  for (std::size_t i = 0; i < history.surveys.size(); ++i) {
    if (!std::isfinite(history.surveys[i].dz)) continue;
    seen.push_back(i);
    mean += times[i + 1];
    baseline = std::max(baseline, history.surveys[i].sigma_baseline);
  }
  if (seen.empty()) return;
  mean /= static_cast<double>(seen.size() + 1);
  double spread = (times.front() - mean) * (times.front() - mean);
  for (const std::size_t i : seen) spread += (times[i + 1] - mean) * (times[i + 1] - mean);
  double rate = 0.0, level = 0.0, variance = square((times.front() - mean) / spread * baseline);
  const auto ownVariance = [](const StationMovement& s) { return square(s.sigma) - square(s.sigma_baseline); };
  for (const std::size_t i : seen) {
    const StationMovement& s = history.surveys[i];
    const double share = (times[i + 1] - mean) / spread;
    rate += share * s.dz;
    level += s.dz / static_cast<double>(seen.size() + 1);
    variance += share * share * ownVariance(s);
  }
  double misfit = square((level + rate * (times.front() - mean)) / baseline);
  for (const std::size_t i : seen) {
    const double off = history.surveys[i].dz - level - rate * (times[i + 1] - mean);
    misfit += square(off) / ownVariance(history.surveys[i]);
  }
  history.rate = rate;
  const LineScatter scatter = scatterAbout(misfit, static_cast<double>(seen.size()) - 1.0);
  history.sigma_rate = std::sqrt(variance * scatter.variance) * student95(scatter.freedom) / kNormal95;
}

/// The largest of all rates is compared with the largest of as many that are only errors (Sidak).
void judgeRates(std::vector<StationHistory>& histories) {
  constexpr double kFalseAlarms = 0.05;
  const auto known =
      std::count_if(histories.begin(), histories.end(), [](const StationHistory& h) { return h.sigma_rate > 0.0; });
  if (known == 0) return;
  const double one = 1.0 - portable::pow(1.0 - kFalseAlarms, 1.0 / static_cast<double>(known));
  for (StationHistory& h : histories) {
    const double chance = portable::erfc(std::abs(h.rate) / h.sigma_rate / std::sqrt(2.0));  // two-sided
    h.significant = h.sigma_rate > 0.0 && chance < one;
  }
}

bool isLeap(int year) { return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0; }

int daysOf(int year, int month) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return kDays[static_cast<std::size_t>(month - 1)] + (month == 2 && isLeap(year) ? 1 : 0);
}

void requireTimes(const std::vector<double>& times, std::size_t surveys) {
  if (times.size() != surveys) {
    throw Error(Error::Kind::Option, "movement", "dates", std::to_string(times.size()),
                "one for each of the " + std::to_string(surveys) + " surveys");
  }
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) continue;
    throw Error(Error::Kind::Option, "movement", "dates", "number " + std::to_string(i + 1),
                "one after the date before");
  }
}

}  // namespace

LineScatter scatterAbout(double misfit, double freedom) {
  constexpr double kOneSided95 = 1.6448536269514722;  // of the normal distribution
  if (!(freedom > 0.0) || misfit <= chiSquareQuantile(freedom, kOneSided95)) return {};
  return {misfit / freedom, freedom};
}

double StationHistory::lod95() const { return kNormal95 * sigma_rate; }

std::vector<StationHistory> historiesOf(const std::vector<Movement>& movements, const std::vector<double>& times) {
  requireTimes(times, movements.size() + 1);
  std::vector<std::vector<StationMovement>> known;
  for (const Movement& m : movements) known.push_back(byDirection(m));
  const auto last =
      std::find_if(movements.rbegin(), movements.rend(), [](const Movement& m) { return !m.stations.empty(); });
  std::vector<StationHistory> histories;
  if (last == movements.rend()) return histories;
  for (const StationMovement& place : last->stations) {
    StationHistory history;
    history.azimuth = place.azimuth, history.direction = withinTurn(place.direction);
    for (const auto& survey : known) history.surveys.push_back(movementAt(survey, history.direction));
    fitRate(history, times);
    histories.push_back(std::move(history));
  }
  judgeRates(histories);
  return histories;
}

double yearOf(int year, int month, int day) {
  int before = day - 1;
  for (int m = 1; m < month; ++m) before += daysOf(year, m);
  return year + before / (isLeap(year) ? 366.0 : 365.0);
}

double yearOf(const std::string& date) {
  const auto refused = [&date] {
    return Error(Error::Kind::Option, "movement", "date", date, "a date as 2024-05-31 or a year as 2024.41");
  };
  int year = 0, month = 0, day = 0, read = 0;
  if (std::sscanf(date.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &read) == 3) {
    const bool plain = date.find_first_not_of("0123456789-") == std::string::npos;  // no sign, no space
    const bool is_month = month >= 1 && month <= 12;
    if (static_cast<std::size_t>(read) != date.size() || !plain || !is_month || day < 1 || day > daysOf(year, month))
      throw refused();
    return yearOf(year, month, day);
  }
  double decimal = 0.0;
  const char* const end = date.data() + date.size();
  const auto typed = std::from_chars(date.data(), end, decimal);
  if (typed.ec != std::errc() || typed.ptr != end || !(decimal > 1800.0 && decimal < 2200.0)) throw refused();
  return decimal;
}

std::vector<double> timesOf(const std::vector<std::string>& dates, std::size_t surveys) {
  std::vector<double> times;
  for (const std::string& date : dates) times.push_back(yearOf(date));
  while (dates.empty() && times.size() < surveys) times.push_back(static_cast<double>(times.size()));
  return times;
}

void requireInOrder(const std::vector<Epoch>& surveys) {
  const auto time = [](const Epoch& survey) {
    try {
      return yearOf(survey.date);
    } catch (const Error&) {
      return kUnknown;
    }
  };
  const Epoch* before = nullptr;  // the last that has a date
  for (const Epoch& now : surveys) {
    if (!std::isfinite(time(now))) continue;
    if (before && time(now) < time(*before)) {
      throw Error(Error::Kind::Option, "movement", "date of " + now.name, now.date,
                  "no earlier than that of " + before->name + ", " + before->date + ": surveys in the order of time");
    }
    before = &now;
  }
}

}  // namespace tank_datum
