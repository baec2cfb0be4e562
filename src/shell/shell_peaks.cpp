#include "shell/shell_peaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tank_datum {
namespace {

/// What a parabola through three values at equal steps rises by above the middle one, which is the largest but for
/// chance, and what a narrower peak may: where each is a mean over a step, by half of what they bend by. Zeros where
/// that is no more than some least, or one is not known.
/// @param mean_over  part of a step that each is a mean over
struct Rise {
  double is = 0.0, may = 0.0;

  Rise(double before, double at, double after, double least, double mean_over) {
    const double bend = at - 0.5 * (before + after), climb = std::min(0.5 * std::abs(after - before), bend);
    if (bend > least) is = climb * climb / (4.0 * bend), may = std::max(climb, 0.5 * mean_over * bend);
  }
};

bool isBetweenEqualSteps(const std::vector<double>& heights, std::size_t k) {
  constexpr double kRounding = 1e-6;  // m
  return k > 0 && k + 1 < heights.size() && std::abs(heights[k + 1] - 2.0 * heights[k] + heights[k - 1]) < kRounding;
}

}  // namespace

void raisePeaks(std::vector<Roundness>& roundness, const ShellGrid& grid,
                const std::vector<std::vector<double>>& deviations, const std::vector<Station>& stations) {
  constexpr double kSurely = 3.0;  // standard errors that three values bend by
  const std::size_t count = stations.size();
  for (Roundness& r : roundness) {
    const auto k =
        static_cast<std::size_t>(std::find(grid.heights.begin(), grid.heights.end(), r.height) - grid.heights.begin());
    const auto has_azimuth = [&](const Station& s) { return s.azimuth == r.azimuth; };
    const auto i =
        static_cast<std::size_t>(std::find_if(stations.begin(), stations.end(), has_azimuth) - stations.begin());
    const double sign = r.max_deviation >= -r.min_deviation ? 1.0 : -1.0;
    const auto out = [&](std::size_t row, std::size_t station) { return sign * deviations[row][station % count]; };
    const double least = kSurely * grid.cells[k][i].sigma;
    const Rise along(out(k, i + count - 1), out(k, i), out(k, i + 1), least,
                     std::min(1.0, static_cast<double>(count) / 360.0));
    r.rise = along.is, r.may_rise = along.may;
    if (isBetweenEqualSteps(grid.heights, k)) {
      const Rise upwards(out(k - 1, i), out(k, i), out(k + 1, i), least, 0.0);
      r.rise += upwards.is, r.may_rise += upwards.may;
    }
    (sign > 0.0 ? r.max_deviation : r.min_deviation) += sign * r.rise;
    r.sigma = std::hypot(r.sigma, r.rise);
  }
}

}  // namespace tank_datum
