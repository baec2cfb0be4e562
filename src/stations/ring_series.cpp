#include "stations/ring_series.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace tank_datum {

RingSeries::RingSeries(const std::vector<Station>& stations, double Station::*quantity, double Station::*sigma)
    : step_(1.01 * kTwoPi / static_cast<double>(std::max<std::size_t>(1, stations.size()))) {
  for (const Station& s : stations) {
    if (std::isfinite(s.*quantity)) values_.push_back({s.azimuth, s.*quantity, s.*sigma});
  }
}

std::optional<RingValue> RingSeries::at(double azimuth) const {
  constexpr double kSame = 1e-9;  // rounding of an azimuth [rad]
  if (values_.empty()) return {};
  azimuth -= kTwoPi * std::floor(azimuth / kTwoPi);
  const auto later = [](const RingValue& v, double a) { return v.azimuth < a; };
  const auto found = std::lower_bound(values_.begin(), values_.end(), azimuth - kSame, later);
  const auto next = static_cast<std::size_t>(found - values_.begin()) % values_.size();
  const RingValue& b = values_[next];
  const RingValue& a = values_[(next + values_.size() - 1) % values_.size()];
  const auto ahead = [](double from, double to) { return to - from - kTwoPi * std::floor((to - from) / kTwoPi); };
  if (std::abs(std::remainder(b.azimuth - azimuth, kTwoPi)) <= kSame) return RingValue{azimuth, b.value, b.sigma};
  const double whole = ahead(a.azimuth, b.azimuth), part = ahead(a.azimuth, azimuth) / whole;
  if (!(whole <= step_)) return {};
  return RingValue{azimuth, (1.0 - part) * a.value + part * b.value,
                   std::hypot((1.0 - part) * a.sigma, part * b.sigma)};
}

}  // namespace tank_datum
