#include "movement/ring_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kStandsOut = 3.0;  // of what the rest scatter by
constexpr double kWidest = 30.0 * kDegree;
constexpr std::size_t kDense = 32;  // stations that tell an arc

}  // namespace

RingPairs::RingPairs(const std::vector<MatchedStation>& stations) : stations_(stations) {
  std::vector<double> arcs;
  for (std::size_t i = 0; i < stations.size(); ++i) arcs.push_back(arc(i, 1));
  step_ = median(arcs);
  if (stations.size() < kDense) return;
  const auto most = static_cast<double>(stations.size() - 1);  // where they lie within less
  widest_ = static_cast<std::size_t>(step_ > 0.0 ? std::min(kWidest / step_ + 1e-6, most) : most);
}

double RingPairs::arc(std::size_t at, std::size_t lag) const {
  return withinTurn(stations_[(at + lag) % stations_.size()].direction - stations_[at].direction);
}

std::vector<std::size_t> RingPairs::pairsAt(const std::vector<double>& values, std::size_t lag) const {
  const double most = kStandsOut * robustSigma(values, 0.0), no_gap = (static_cast<double>(lag) + 0.5) * step_;
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double larger = std::max(std::abs(values[i]), std::abs(values[(i + lag) % values.size()]));
    if (larger <= most && arc(i, lag) <= no_gap) pairs.push_back(i);
  }
  return pairs;
}

double RingPairs::scatterOf(const std::vector<double>& values) const {
  const double all = biweightSigma(values);
  if (widest_ == 0) return all;
  std::vector<MatchedStation> pairs;
  for (const std::size_t i : pairsAt(values, widest_)) {
    MatchedStation pair;
    pair.direction = stations_[i].direction + 0.5 * arc(i, widest_);
    pair.dz = (values[(i + widest_) % values.size()] - values[i]) / std::sqrt(2.0);
    pair.sigma = 1.0;
    pairs.push_back(pair);
  }
  if (pairs.empty() || 3 * pairs.size() < values.size()) return all;
  CommonPart(pairs, Removal::Tilt, true).removeFrom(pairs);
  std::vector<double> differences;
  for (const MatchedStation& pair : pairs) differences.push_back(pair.dz);
  const double most = kStandsOut * robustSigma(differences, 0.0);
  const auto stands_out = [most](double difference) { return std::abs(difference) > most; };
  differences.erase(std::remove_if(differences.begin(), differences.end(), stands_out), differences.end());
  return std::min(all, biweightSigma(differences));
}

double RingPairs::correlationAt(const std::vector<double>& values, std::size_t lag, double scatter) const {
  std::vector<double> differences;
  for (const std::size_t i : pairsAt(values, lag)) differences.push_back(values[(i + lag) % values.size()] - values[i]);
  return 1.0 - 0.5 * square(biweightSigma(differences) / scatter);
}

}  // namespace tank_datum
