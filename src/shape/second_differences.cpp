#include "tank_datum/shape/second_differences.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/units.h"
#include "stations/ring_series.h"

namespace tank_datum {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kClosest = 15.0 * kFoot;  // points nearer than this measure noise
constexpr double kWidest = 32.0 * kFoot;   // the code's own
constexpr double kSound = 22.0 * kFoot;    // beyond it curvature is missed
constexpr double kWanted = 20.0 * kFoot;
constexpr int kFewestPoints = 8;
constexpr double kRounding = 1e-6;

template <typename... Values>
std::string formatted(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

bool equallySpaced(const std::vector<Station>& stations) {
  const double step = kTwoPi / static_cast<double>(stations.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double to_next = stations[(i + 1) % stations.size()].azimuth - stations[i].azimuth;
    if (std::abs(std::remainder(to_next - step, kTwoPi)) > 0.01 * step) return false;
  }
  return !stations.empty();
}

/// Why a survey of so many points is none for the classic rule; or empty.
std::string objection(int points, double circumference) {
  const double spacing = circumference / points;
  if (points < kFewestPoints) return formatted("%d points, and the rule wants at least %d", points, kFewestPoints);
  if (points % 2 != 0) return formatted("%d points, and the rule wants an even number", points);
  if (spacing > kWidest + kRounding)
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

void addStart(const RingSeries& u, double start, int points, std::vector<PlacedValue>& all) {
  const double step = kTwoPi / points;
  for (int i = 0; i < points; ++i) {
    const auto before = u.at(start + (i - 1) * step), here = u.at(start + i * step),
               after = u.at(start + (i + 1) * step);
    if (!before || !here || !after) continue;
    const double value = here->value - 0.5 * (before->value + after->value);
    all.push_back({std::abs(value), std::hypot(here->sigma, 0.5 * before->sigma, 0.5 * after->sigma), here->azimuth});
  }
}

}  // namespace

SecondDifferences secondDifferencesOf(const std::vector<Station>& stations, double radius, int points) {
  SecondDifferences result;
  const auto count = static_cast<int>(stations.size());
  const double circumference = kTwoPi * radius;
  if (!equallySpaced(stations)) {
    result.message = "the stations are not equally spaced";
    return result;
  }
  const bool sparse = circumference / count >= kClosest - kRounding;
  const bool chosen = points == 0;
  if (chosen) points = sparse ? count : 2 * static_cast<int>(std::lround(circumference / kWanted / 2.0));
  if (points > count) {
    result.message = formatted("%d points asked for, and only %d stations", points, count);
    return result;
  }
  if (chosen && points < kFewestPoints && !sparse) {
    result.message = "the tank is too small for 8 points 4.6 m (15 ft) apart";
    return result;
  }
  result.message = objection(points, circumference);
  if (!result.message.empty()) return result;
  result.points = points;
  result.spacing = circumference / points;
  result.starts = std::max(1, count / points);
  const RingSeries u(stations, &Station::u, &Station::sigma_z);
  for (int start = 0; start < result.starts; ++start) {
    addStart(u, stations[static_cast<std::size_t>(start)].azimuth, points, result.all);
  }
  if (result.spacing > kSound + kRounding) {
    result.message =
        formatted("points %.2f m apart see less of the curvature than those at 15 to 22 ft", result.spacing);
  }
  if (result.all.empty()) result.message = "no three neighbouring points have an elevation";
  return result;
}

}  // namespace tank_datum
