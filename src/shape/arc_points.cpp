#include "shape/arc_points.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/units.h"
#include "limits/survey_spacing.h"
#include "stations/placed_value.h"

namespace tank_datum {
namespace {

constexpr std::size_t kMostPoints = 64;
constexpr int kFewestPoints = 8;

/// Survey points among dense stations, the first at the station furthest out of plane.
std::vector<double> pointsOf(const std::vector<RingValue>& u, double radius) {
  const auto furthest = std::max_element(
      u.begin(), u.end(), [](const RingValue& a, const RingValue& b) { return std::abs(a.value) < std::abs(b.value); });
  const int wanted = 2 * static_cast<int>(std::lround(kTwoPi * radius / kSurveySpacing / 2.0));
  const int count = std::clamp(wanted, kFewestPoints, static_cast<int>(kMostPoints));
  std::vector<double> azimuths;
  for (int i = 0; i < count; ++i) azimuths.push_back(withinTurn(furthest->azimuth + kTwoPi * i / count));
  std::sort(azimuths.begin(), azimuths.end());
  return azimuths;
}

}  // namespace

ArcPoints::ArcPoints(const std::vector<Station>& stations, double radius) : radius_(radius) {
  const std::vector<RingValue> u = RingSeries(stations, &Station::u, &Station::sigma_z).values();
  of_regression_ =
      std::any_of(stations.begin(), stations.end(), [](const Station& s) { return std::isfinite(s.u_fit); });
  if (of_regression_) {
    values_ = RingSeries(stations, &Station::u_fit, &Station::sigma_u_fit).values();
    return;
  }
  if (u.size() <= kMostPoints) {
    values_ = u;
    return;
  }
  const std::vector<double> azimuths = pointsOf(u, radius);
  const double reach = 0.25 * kTwoPi / static_cast<double>(azimuths.size()) + 1e-9;
  for (const double azimuth : azimuths) {
    std::vector<std::size_t> members;
    RingValue mean{azimuth, 0.0, 0.0};
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (std::abs(std::remainder(u[i].azimuth - azimuth, kTwoPi)) > reach) continue;
      members.push_back(i);
      mean.value += u[i].value, mean.sigma += u[i].sigma * u[i].sigma;
    }
    if (members.empty()) continue;
    const auto count = static_cast<double>(members.size());
    mean.value /= count, mean.sigma = std::sqrt(mean.sigma) / count;
    values_.push_back(mean);
    members_.push_back(std::move(members));
  }
}

std::vector<double> ArcPoints::reduce(const double* u) const {
  if (members_.empty()) return std::vector<double>(u, u + values_.size());
  std::vector<double> reduced;
  for (const std::vector<std::size_t>& members : members_) {
    double sum = 0.0;
    for (const std::size_t i : members) sum += u[i];
    reduced.push_back(sum / static_cast<double>(members.size()));
  }
  return reduced;
}

std::vector<SettlementArc> ArcPoints::arcsOf(const std::vector<double>& u) const {
  std::vector<RingValue> values = values_;
  for (std::size_t i = 0; i < values.size(); ++i) values[i].value = u[i];
  return arcsOf(values);
}

std::vector<SettlementArc> ArcPoints::arcsOf(const std::vector<RingValue>& v) const {
  std::vector<std::size_t> crossings;  // the value before each
  for (std::size_t i = 0; i < v.size(); ++i) {
    if ((v[i].value < 0.0) != (v[(i + 1) % v.size()].value < 0.0)) crossings.push_back(i);
  }
  const auto zero = [&](std::size_t i) {
    const RingValue &a = v[i], &b = v[(i + 1) % v.size()];
    return a.azimuth + turnAhead(a.azimuth, b.azimuth) * a.value / (a.value - b.value);
  };
  std::vector<SettlementArc> arcs;
  for (std::size_t c = 0; c < crossings.size(); ++c) {
    const std::size_t end = crossings[(c + 1) % crossings.size()];
    SettlementArc arc;
    arc.length = crossings.size() == 2 ? kPi * radius_ : radius_ * turnAhead(zero(crossings[c]), zero(end));
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
