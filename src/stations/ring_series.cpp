#include "stations/ring_series.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/units.h"

namespace tank_datum {

double turnAhead(double from, double to) { return withinTurn(to - from); }

RingSeries::RingSeries(const std::vector<Station>& stations, double Station::*quantity, double Station::*sigma) {
  constexpr double kGap = 2.0;  // of the mean distance: between typed stations that are not equally spaced
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[i];
    if (!std::isfinite(s.*quantity)) continue;
    values_.push_back({s.azimuth, s.*quantity, s.*sigma});
    numbers.push_back(i);
  }
  const double widest = 1.01 * kGap * kTwoPi / static_cast<double>(std::max<std::size_t>(1, stations.size()));
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const std::size_t next = (i + 1) % values_.size();
    const bool neighbours = (numbers[i] + 1) % stations.size() == numbers[next];
    joined_.push_back(neighbours && turnAhead(values_[i].azimuth, values_[next].azimuth) <= widest);
  }
}

std::optional<RingPlace> RingSeries::placeOf(double azimuth) const {
  constexpr double kSame = 1e-9;  // rounding of an azimuth [rad]
  if (values_.empty()) return {};
  azimuth = withinTurn(azimuth);
  const auto later = [](const RingValue& v, double a) { return v.azimuth < a; };
  const auto found = std::lower_bound(values_.begin(), values_.end(), azimuth - kSame, later);
  const auto next = static_cast<std::size_t>(found - values_.begin()) % values_.size();
  const std::size_t last = (next + values_.size() - 1) % values_.size();
  if (std::abs(std::remainder(values_[next].azimuth - azimuth, kTwoPi)) <= kSame) return RingPlace{next, next, 0.0};
  if (!joined_[last]) return {};
  const double from = values_[last].azimuth;
  return RingPlace{last, next, turnAhead(from, azimuth) / turnAhead(from, values_[next].azimuth)};
}

std::optional<RingValue> RingSeries::at(double azimuth) const {
  const auto place = placeOf(azimuth);
  if (!place) return {};
  const RingValue &a = values_[place->before], &b = values_[place->after];
  if (place->before == place->after) return RingValue{azimuth, a.value, a.sigma};
  const double share = place->share;
  return RingValue{azimuth, (1.0 - share) * a.value + share * b.value,
                   std::hypot((1.0 - share) * a.sigma, share * b.sigma)};
}

}  // namespace tank_datum
