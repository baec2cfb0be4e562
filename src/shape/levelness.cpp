#include "shape/levelness.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "stations/ring_series.h"

namespace tank_datum {
namespace {

constexpr double kRounding = 1e-6;

void keepLarger(PlacedValue& largest, const PlacedValue& candidate) {
  if (isLarger(largest, candidate)) largest = candidate;
}

}  // namespace

PlacedValue steepest(const std::vector<Station>& stations, double radius, double arc, double Station::*quantity) {
  PlacedValue largest;
  const RingSeries series(stations, quantity, &Station::sigma_z);
  if (arc >= kPi * radius) return largest;
  for (const RingValue& here : series.values()) {
    for (const double ahead :
         {arc / radius, -arc / radius}) {  // between straight lines it is largest from or to a station
      const auto there = series.at(here.azimuth + ahead);
      if (!there) continue;
      const double start = ahead > 0.0 ? here.azimuth : there->azimuth;
      keepLarger(largest,
                 {std::abs(there->value - here.value) / arc, std::hypot(there->sigma, here.sigma) / arc, start});
    }
  }
  return largest;
}

PlacedValue unevennessWithin(const std::vector<Station>& stations, double radius, double arc) {
  PlacedValue largest;
  const std::vector<RingValue> values = RingSeries(stations, &Station::z, &Station::sigma_z).values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const RingValue *low = &values[i], *high = &values[i];
    for (std::size_t j = 1; j < values.size(); ++j) {
      const RingValue& v = values[(i + j) % values.size()];
      const double ahead = v.azimuth - values[i].azimuth + (i + j >= values.size() ? kTwoPi : 0.0);
      if (radius * ahead > arc * (1.0 + kRounding)) break;
      if (v.value < low->value) low = &v;
      if (v.value > high->value) high = &v;
    }
    if (low == high) continue;
    const double middle = values[i].azimuth + 0.5 * arc / radius;
    keepLarger(largest, {0.5 * (high->value - low->value), 0.5 * std::hypot(high->sigma, low->sigma),
                         middle - kTwoPi * std::floor(middle / kTwoPi)});
  }
  return largest;
}

PlacedValue unevennessOfAll(const std::vector<Station>& stations) {
  PlacedValue largest;
  const std::vector<RingValue> values = RingSeries(stations, &Station::z, &Station::sigma_z).values();
  double mean = 0.0;
  for (const RingValue& v : values) mean += v.value / static_cast<double>(values.size());
  for (const RingValue& v : values) keepLarger(largest, {std::abs(v.value - mean), v.sigma, v.azimuth});
  return largest;
}

}  // namespace tank_datum
