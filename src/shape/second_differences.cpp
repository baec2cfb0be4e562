#include "shape/second_differences.h"

#include <algorithm>
#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "limits/survey_spacing.h"
#include "shape/survey_rows.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

constexpr double kClosest = 15.0 * kMetresPerFoot;  // points nearer than this measure noise
constexpr double kSound = 22.0 * kMetresPerFoot;    // beyond it curvature is missed
constexpr int kFewestPoints = 8;
constexpr double kRounding = 1e-6;

/// Why a survey of so many points is none for the classic rule; or empty.
std::string objection(int points, double circumference) {
  const double spacing = circumference / points;
  if (points < kFewestPoints) return formatted("%d points, and the rule wants at least %d", points, kFewestPoints);
  if (points % 2 != 0) return formatted("%d points, and the rule wants an even number", points);
  if (spacing > kWidestSpacing + kRounding)
    return formatted("points %.2f m apart, and the rule wants 9.75 m (32 ft) at most", spacing);
  if (spacing < kClosest - kRounding) {
    return formatted(
        "points %.2f m apart: the limit falls with the square of the distance and noise does not, so below "
        "4.6 m (15 ft) the rule judges noise; %d to %d points are sound here",
        spacing, std::max(kFewestPoints, 2 * static_cast<int>(std::ceil(circumference / kSound / 2.0))),
        2 * static_cast<int>(circumference / kClosest / 2.0));
  }
  return {};
}

/// Where surveys start: at every station, and at so many places between that there are at least kFewestStarts.
/// Starts a whole number of points apart are the same survey.
std::vector<double> startsOf(const std::vector<Station>& stations, int points) {
  constexpr double kSame = 1e-7;  // [rad]
  constexpr double kFewestStarts = 10.0;
  const double step = kTwoPi / points;
  std::vector<double> starts;
  const auto put = [&](double azimuth) {
    const double start = azimuth - step * std::floor(azimuth / step + kSame);
    const bool known = std::any_of(starts.begin(), starts.end(),
                                   [&](double s) { return std::abs(std::remainder(s - start, step)) < kSame; });
    if (!known) starts.push_back(start);
  };
  for (const Station& s : stations) put(s.azimuth);
  const std::vector<double> at_stations = starts;
  const auto count = static_cast<double>(starts.size());
  const double parts = std::ceil(kFewestStarts / count);
  for (double i = 1.0; i < parts; ++i) {
    for (const double s : at_stations) put(s + step / count * i / parts);
  }
  std::sort(starts.begin(), starts.end());
  return starts;
}

}  // namespace

SurveyPlan planSurvey(const std::vector<Station>& stations, double radius, int points) {
  SurveyPlan plan;
  const auto count = static_cast<int>(stations.size());
  const double circumference = kTwoPi * radius;
  if (count == 0) {
    plan.message = "there are no stations";
    return plan;
  }
  const bool sparse = circumference / count >= kClosest - kRounding;
  const bool chosen = points == 0;
  if (chosen) points = sparse ? count : 2 * static_cast<int>(std::lround(circumference / kSurveySpacing / 2.0));
  if (points > count) {
    plan.message = formatted("%d points asked for, and only %d stations", points, count);
    return plan;
  }
  if (chosen && points < kFewestPoints && !sparse) {
    plan.message = "the tank is too small for 8 points 4.6 m (15 ft) apart";
    return plan;
  }
  plan.message = objection(points, circumference);
  if (!plan.message.empty()) return plan;
  plan.points = points;
  plan.spacing = circumference / points;
  plan.as_they_are = points == count;
  plan.starts = plan.as_they_are ? std::vector<double>{stations.front().azimuth} : startsOf(stations, points);
  if (plan.spacing > kSound + kRounding) {
    plan.message = formatted("points %.2f m apart see less of the curvature than those at 15 to 22 ft", plan.spacing);
  }
  return plan;
}

SecondDifferences secondDifferencesOf(const std::vector<Station>& stations, double radius, int points) {
  const SurveyPlan plan = planSurvey(stations, radius, points);
  SecondDifferences result;
  result.message = plan.message;
  if (!plan.valid()) return result;
  result.points = plan.points;
  result.spacing = plan.spacing;
  result.starts = static_cast<int>(plan.starts.size());
  const RingSeries u(stations, &Station::u, &Station::sigma_z);
  const RingRows rows = secondDifferenceRows(u, plan, radius);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    result.all.push_back(rows.of(row, u.values()));
    result.spacings.push_back(plan.spacing / std::sqrt(rows.scale(row)));
  }
  if (rows.empty()) {
    result.message = "no three neighbouring points have an elevation";
  } else {
    result.worst = rows.largest(u.values());
  }
  return result;
}

}  // namespace tank_datum
