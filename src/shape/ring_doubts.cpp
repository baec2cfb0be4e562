#include "shape/ring_doubts.h"

#include <algorithm>
#include <cmath>

#include "core/deviates.h"
#include "core/ring_runs.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "stations/ring_series.h"

namespace tank_datum {

RingDoubts::RingDoubts(const std::vector<Station>& stations, const Eigen::VectorXd& expected,
                       const Eigen::VectorXd& sigmas) {
  std::vector<double> refused, unsure;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[i];
    const auto at = static_cast<Eigen::Index>(i);
    refused.push_back(s.z_refused - expected[at]);
    const bool exceeds = s.flag == StationFlag::Interpolated && !std::isfinite(s.z_refused) && s.sigma_z > sigmas[at];
    unsure.push_back(exceeds ? std::sqrt(s.sigma_z * s.sigma_z - sigmas[at] * sigmas[at]) : kUnknown);
  }
  add(stations, refused, true);
  add(stations, unsure, false);
}

/// @param values  at each station, unknown at those that are not in doubt [m]
void RingDoubts::add(const std::vector<Station>& stations, const std::vector<double>& values, bool refused) {
  const std::size_t count = stations.size();
  std::vector<char> in_doubt;
  for (const double v : values) in_doubt.push_back(std::isfinite(v) ? 1 : 0);
  if (std::count(in_doubt.begin(), in_doubt.end(), 0) < 2) return;
  for (const RingRun& run : runsRound(in_doubt)) {
    Gap gap{stations[(run.first + count - 1) % count].azimuth, {0.0}, {0.0}, refused};
    for (std::size_t k = run.first; k <= run.last + 1; ++k) {
      gap.ahead.push_back(turnAhead(gap.first, stations[k % count].azimuth));
      gap.values.push_back(k > run.last ? 0.0 : values[k % count]);
    }
    gaps_.push_back(std::move(gap));
  }
}

double RingDoubts::Gap::at(double azimuth) const {
  const double here = turnAhead(first, azimuth);
  const auto after = std::upper_bound(ahead.begin(), ahead.end(), here);
  if (after == ahead.end()) return 0.0;
  const auto k = static_cast<std::size_t>(after - ahead.begin());  // at least 1: the first is nothing ahead
  const double share = (here - ahead[k - 1]) / (ahead[k] - ahead[k - 1]);
  return (1.0 - share) * values[k - 1] + share * values[k];
}

Eigen::MatrixXd RingDoubts::at(const Eigen::VectorXd& azimuths) const {
  Eigen::MatrixXd all(azimuths.size(), static_cast<Eigen::Index>(gaps_.size()));
  for (Eigen::Index k = 0; k < all.cols(); ++k) {
    for (Eigen::Index i = 0; i < all.rows(); ++i) all(i, k) = gaps_[static_cast<std::size_t>(k)].at(azimuths[i]);
  }
  return all;
}

Eigen::MatrixXd RingDoubts::waves(int order) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(2 * order + 1, static_cast<Eigen::Index>(gaps_.size()));
  for (Eigen::Index g = 0; g < all.cols(); ++g) {
    const Gap& gap = gaps_[static_cast<std::size_t>(g)];
    for (std::size_t k = 1; k + 1 < gap.ahead.size(); ++k) {
      const double arc = 0.5 * (gap.ahead[k + 1] - gap.ahead[k - 1]);
      all.col(g) += arc * gap.values[k] / kPi * harmonicRow(gap.first + gap.ahead[k], order).transpose();
    }
  }
  all.row(0) *= 0.5;
  return all;
}

Eigen::MatrixXd RingDoubts::drawn(int draws, std::uint64_t seed) const {
  Deviates normal(seed);
  Eigen::MatrixXd all(static_cast<Eigen::Index>(gaps_.size()), draws);
  for (Eigen::Index k = 0; k < all.cols(); ++k) {
    for (Eigen::Index g = 0; g < all.rows(); ++g) {
      const double deviate = normal();
      all(g, k) = !gaps_[static_cast<std::size_t>(g)].refused ? deviate : deviate > 0.0 ? 1.0 : 0.0;
    }
  }
  return all;
}

}  // namespace tank_datum
