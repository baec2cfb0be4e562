#include "fit/adaptive_smooth.h"

#include <Eigen/Dense>
#include <cmath>

namespace tank_datum {
namespace {

/// The weighted parabola over the values within `reach` steps of one; not finite where they are too few.
SeriesValue parabolaAt(const std::vector<SeriesValue>& series, std::size_t at, std::size_t reach) {
  constexpr int kFewestValues = 5;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
  double shared = 1.0;
  int before = 0, after = 0;
  const auto count = static_cast<std::ptrdiff_t>(series.size()), width = static_cast<std::ptrdiff_t>(reach);
  for (std::ptrdiff_t off = -width; off <= width; ++off) {
    const SeriesValue& v = series[static_cast<std::size_t>((static_cast<std::ptrdiff_t>(at) + off + count) % count)];
    if (!std::isfinite(v.value)) continue;
    const double t = static_cast<double>(off) / static_cast<double>(reach), weight = 1.0 / (v.sigma * v.sigma);
    const Eigen::Vector3d row(1.0, t, t * t);
    normal += weight * row * row.transpose();
    rhs += weight * v.value * row;
    shared = std::max(shared, v.shared);
    before += off < 0;
    after += off > 0;
  }
  if (before == 0 || after == 0 || before + after + 1 < kFewestValues) return {NAN, NAN, 1.0};
  const Eigen::Matrix3d inverse = normal.inverse();
  return {inverse.row(0) * rhs, std::sqrt(inverse(0, 0) * shared), 1.0};  // neighbours share points
}

}  // namespace

std::vector<SeriesValue> smoothed(const std::vector<SeriesValue>& series, std::size_t widest) {
  constexpr double kAgree = 3.0;  // standard errors
  std::vector<SeriesValue> result = series;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!std::isfinite(series[i].value)) continue;
    double low = series[i].value - kAgree * series[i].sigma, high = series[i].value + kAgree * series[i].sigma;
    for (std::size_t reach = 2; reach <= widest && 2 * reach < series.size(); reach = reach + 1 + reach / 3) {
      const SeriesValue wide = parabolaAt(series, i, reach);
      if (!std::isfinite(wide.value)) continue;
      low = std::max(low, wide.value - kAgree * wide.sigma);
      high = std::min(high, wide.value + kAgree * wide.sigma);
      if (low > high) break;
      if (wide.sigma < result[i].sigma) result[i] = wide;
    }
  }
  return result;
}

BetweenValues::BetweenValues(const std::vector<SeriesValue>& series, std::size_t place, std::size_t stride)
    : left_(place / stride),
      right_((left_ + 1) % series.size()),
      share_(static_cast<double>(place - left_ * stride) / static_cast<double>(stride)) {
  if (!std::isfinite(series[left_].value)) left_ = right_;
  if (!std::isfinite(series[right_].value)) right_ = left_;
  known_ = std::isfinite(series[left_].value);
}

bool BetweenValues::known() const { return known_; }

double BetweenValues::mean(const std::vector<SeriesValue>& series, double SeriesValue::*what) const {
  return (1.0 - share_) * series[left_].*what + share_ * series[right_].*what;
}

}  // namespace tank_datum
