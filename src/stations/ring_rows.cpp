#include "stations/ring_rows.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"

namespace tank_datum {

void RingRows::add(double azimuth, const std::vector<std::pair<RingPlace, double>>& parts, double scale) {
  const std::size_t begin = terms_.size();
  const auto put = [&](std::size_t value, double weight) {
    if (weight == 0.0) return;
    for (std::size_t t = begin; t < terms_.size(); ++t) {
      if (terms_[t].value != value) continue;
      terms_[t].weight += weight;
      return;
    }
    terms_.push_back({value, weight});
  };
  for (const auto& [place, weight] : parts) {
    put(place.before, (1.0 - place.share) * weight);
    put(place.after, place.share * weight);
  }
  azimuths_.push_back(withinTurn(azimuth));
  scales_.push_back(scale);
  ends_.push_back(terms_.size());
}

PlacedValue RingRows::of(std::size_t row, const std::vector<RingValue>& values) const {
  double sum = 0.0, variance = 0.0;
  for (std::size_t t = row == 0 ? 0 : ends_[row - 1]; t < ends_[row]; ++t) {
    const RingValue& v = values[terms_[t].value];
    sum += terms_[t].weight * v.value;
    variance += terms_[t].weight * terms_[t].weight * v.sigma * v.sigma;
  }
  return {std::abs(sum), std::sqrt(variance), azimuths_[row]};
}

std::size_t RingRows::largest(const std::vector<RingValue>& values) const {
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t row = 0; row < size(); ++row) {
    const double here = scales_[row] * of(row, values).value;
    if (here > most) most = here, best = row;
  }
  return best;
}

double RingRows::sum(std::size_t row, const double* values) const {
  double sum = 0.0;
  for (std::size_t t = row == 0 ? 0 : ends_[row - 1]; t < ends_[row]; ++t)
    sum += terms_[t].weight * values[terms_[t].value];
  return sum;
}

double RingRows::largest(const double* values) const {
  double most = 0.0;
  for (std::size_t row = 0; row < size(); ++row) most = std::max(most, scales_[row] * std::abs(sum(row, values)));
  return most;
}

}  // namespace tank_datum
