#include "shape/ring_doubts.h"

#include <algorithm>
#include <cmath>

#include "core/deviates.h"
#include "core/ring_runs.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "stations/ring_series.h"

namespace tank_datum {

RingDoubts::RingDoubts(const std::vector<Station>& stations, const Eigen::VectorXd& expected) {
  const std::size_t count = stations.size();
  std::vector<char> in_doubt;
  for (const Station& s : stations) in_doubt.push_back(std::isfinite(s.z_refused) ? 1 : 0);
  if (std::count(in_doubt.begin(), in_doubt.end(), 0) < 2) return;
  for (const RingRun& run : runsRound(in_doubt)) {
    Gap gap{stations[(run.first + count - 1) % count].azimuth, {0.0}, {0.0}};
    for (std::size_t k = run.first; k <= run.last + 1; ++k) {
      const Station& s = stations[k % count];
      gap.ahead.push_back(turnAhead(gap.first, s.azimuth));
      gap.values.push_back(k > run.last ? 0.0 : s.z_refused - expected[static_cast<Eigen::Index>(k % count)]);
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
  return Eigen::MatrixXd::NullaryExpr(static_cast<Eigen::Index>(gaps_.size()), draws,
                                      [&normal]() { return normal() > 0.0 ? 1.0 : 0.0; });
}

}  // namespace tank_datum
