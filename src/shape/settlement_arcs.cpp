#include "tank_datum/shape/settlement_arcs.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "stations/ring_series.h"

namespace tank_datum {

std::vector<SettlementArc> settlementArcs(const std::vector<Station>& stations, double radius) {
  const bool dense = stations.size() > 64 && std::any_of(stations.begin(), stations.end(),
                                                         [](const Station& s) { return std::isfinite(s.u_fit); });
  const RingSeries u = dense ? RingSeries(stations, &Station::u_fit, &Station::sigma_u_fit)
                             : RingSeries(stations, &Station::u, &Station::sigma_z);
  const std::vector<RingValue>& v = u.values();
  std::vector<std::size_t> crossings;  // the value before each
  for (std::size_t i = 0; i < v.size(); ++i) {
    if ((v[i].value < 0.0) != (v[(i + 1) % v.size()].value < 0.0)) crossings.push_back(i);
  }
  const auto turned = [](double a) { return a - kTwoPi * std::floor(a / kTwoPi); };
  const auto zero = [&](std::size_t i) {
    const RingValue &a = v[i], &b = v[(i + 1) % v.size()];
    return a.azimuth + turned(b.azimuth - a.azimuth) * a.value / (a.value - b.value);
  };
  std::vector<SettlementArc> arcs;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const std::size_t end = crossings[(c + 1) % crossings.size()];
    SettlementArc arc;
    arc.length = radius * turned(zero(end) - zero(crossings[c]));
    for (std::size_t i = crossings[c]; i != end;) {
      i = (i + 1) % v.size();
      const PlacedValue here{std::abs(v[i].value), v[i].sigma, v[i].azimuth};
      if (isLarger(arc.largest, here)) arc.largest = here;
    }
    arcs.push_back(arc);
  }
  return arcs;
}

}  // namespace tank_datum
