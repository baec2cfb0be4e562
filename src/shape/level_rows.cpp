#include "shape/level_rows.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "stations/placed_value.h"

namespace tank_datum {
namespace {

constexpr double kRounding = 1e-6;

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
      rows.add(ahead > 0.0 ? v[i].azimuth : v[i].azimuth + ahead, {{*there, 1.0 / arc}, {atValue(i), -1.0 / arc}});
    }
  }
  return rows;
}

RingRows levelRows(const RingSeries& series, double radius, double arc) {
  RingRows rows;
  const std::vector<RingValue>& v = series.values();
  const auto add = [&](double from, double to, const RingPlace& a, const RingPlace& b) {
    const double middle = from + 0.5 * turnAhead(from, to);
    rows.add(middle, {{b, 0.5}, {a, -0.5}});
  };
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 1; k < v.size(); ++k) {
      const std::size_t j = (i + k) % v.size();
      if (radius * turnAhead(v[i].azimuth, v[j].azimuth) > arc * (1.0 + kRounding)) break;
      add(v[i].azimuth, v[j].azimuth, atValue(i), atValue(j));
    }
    if (arc >= kPi * radius) continue;
    const double reach = arc / radius;
    const auto after = series.placeOf(v[i].azimuth + reach), before = series.placeOf(v[i].azimuth - reach);
    if (after) add(v[i].azimuth, v[i].azimuth + reach, atValue(i), *after);
    if (before) add(v[i].azimuth - reach, v[i].azimuth, *before, atValue(i));
  }
  return rows;
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
