#include "shape/level_rows.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "stations/placed_value.h"

namespace tank_datum {
namespace {

constexpr double kRoundedArc = 1e-6;

RingPlace atValue(std::size_t i) { return {i, i, 0.0}; }

}  // namespace

RingRows slopeRows(const RingSeries& series, double radius, double arc) {
  RingRows rows;
  if (arc >= kPi * radius) return rows;
  const std::vector<RingValue>& v = series.values();
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (const double ahead : {arc / radius, -arc / radius}) {
      const auto there = series.placeOf(v[i].azimuth + ahead);
      if (!there) continue;
      rows.add(v[i].azimuth + 0.5 * ahead, {{*there, 1.0 / arc}, {atValue(i), -1.0 / arc}});
    }
  }
  return rows;
}

LevelWithin::LevelWithin(const RingSeries& series, double radius, double arc) {
  const std::vector<RingValue>& v = series.values();
  std::size_t k = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto within = [&](std::size_t ahead) {
      return radius * turnAhead(v[i].azimuth, v[(i + ahead) % v.size()].azimuth) <= arc * (1.0 + kRoundedArc);
    };
    k = k == 0 ? 0 : k - 1;  // the window's end never goes back
    while (k + 1 < v.size() && within(k + 1)) ++k;
    ahead_.push_back(k);
    pairs_ = pairs_ || k > 0;
  }
  if (arc >= kPi * radius) return;
  const double reach = arc / radius;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto after = series.placeOf(v[i].azimuth + reach), before = series.placeOf(v[i].azimuth - reach);
    if (after) edges_.add(v[i].azimuth + 0.5 * reach, {{*after, 0.5}, {atValue(i), -0.5}});
    if (before) edges_.add(v[i].azimuth - 0.5 * reach, {{atValue(i), 0.5}, {*before, -0.5}});
  }
}

/// A window that goes round once; its largest and smallest values lie at the heads of two queues in order.
template <typename Value>
LevelWithin::Range LevelWithin::widest(Value value) const {
  const std::size_t count = ahead_.size();
  std::vector<std::size_t> high(2 * count), low(2 * count);
  std::size_t high_head = 0, high_end = 0, low_head = 0, low_end = 0, end = 0;
  Range best;
  for (std::size_t i = 0; i < count; ++i) {
    for (; end <= i + ahead_[i]; ++end) {
      const double here = value(end % count);
      while (high_end > high_head && value(high[high_end - 1] % count) <= here) --high_end;
      while (low_end > low_head && value(low[low_end - 1] % count) >= here) --low_end;
      high[high_end++] = low[low_end++] = end;
    }
    while (high[high_head] < i) ++high_head;
    while (low[low_head] < i) ++low_head;
    const std::size_t highest = high[high_head] % count, lowest = low[low_head] % count;
    const double half = 0.5 * (value(highest) - value(lowest));
    if (half > best.half) best = {highest, lowest, half};
  }
  return best;
}

double LevelWithin::largest(const double* values) const {
  if (empty()) return 0.0;
  return std::max(edges_.largest(values), widest([values](std::size_t i) { return values[i]; }).half);
}

PlacedValue LevelWithin::largest(const std::vector<RingValue>& values) const {
  if (empty()) return {};
  const Range range = widest([&values](std::size_t i) { return values[i].value; });
  const double from = values[range.highest].azimuth, to = values[range.lowest].azimuth;
  const double ahead = turnAhead(from, to), back = turnAhead(to, from);
  RingRows pair;
  pair.add(ahead <= back ? from + 0.5 * ahead : to + 0.5 * back,
           {{atValue(range.highest), 0.5}, {atValue(range.lowest), -0.5}});
  const PlacedValue between = pair.of(0, values);
  if (edges_.empty()) return between;
  const PlacedValue edge = edges_.of(edges_.largest(values), values);
  return pairs_ && between.value >= edge.value ? between : edge;
}

MeanLevel::MeanLevel(const RingSeries& series, const std::vector<Station>& stations) {
  const std::size_t n = stations.size();
  double total = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(stations[i].z)) continue;
    const double before = stations[(i + n - 1) % n].azimuth, after = stations[(i + 1) % n].azimuth;
    const double here = stations[i].azimuth;
    shares_.push_back(n > 1 ? turnAhead(before, here) + turnAhead(here, after) : 1.0);
    total += shares_.back();
  }
  shares_.resize(series.values().size(), 0.0);
  for (double& share : shares_) share /= total;
}

PlacedValue MeanLevel::furthest(const std::vector<RingValue>& values) const {
  double mean = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) mean += shares_[i] * values[i].value;
  PlacedValue largest;
  for (const RingValue& v : values) {
    const PlacedValue here{std::abs(v.value - mean), v.sigma, v.azimuth};
    if (isLarger(largest, here)) largest = here;
  }
  return largest;
}

double MeanLevel::furthest(const double* values) const {
  double mean = 0.0, most = 0.0;
  for (std::size_t i = 0; i < shares_.size(); ++i) mean += shares_[i] * values[i];
  for (std::size_t i = 0; i < shares_.size(); ++i) most = std::max(most, std::abs(values[i] - mean));
  return most;
}

}  // namespace tank_datum
