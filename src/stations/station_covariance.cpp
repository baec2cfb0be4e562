#include "stations/station_covariance.h"

#include <cmath>

namespace tank_datum {

double StationCovariance::sigma(std::size_t station) const {
  const auto i = static_cast<Eigen::Index>(station);
  const double shared = factors.rows() > 0 ? factors.col(i).squaredNorm() : 0.0;
  return std::sqrt(independent[i] * independent[i] + shared);
}

Eigen::MatrixXd StationCovariance::dense(const std::vector<std::size_t>& stations) const {
  const auto count = static_cast<Eigen::Index>(stations.size());
  Eigen::MatrixXd shared(factors.rows(), count);
  Eigen::VectorXd own(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto i = static_cast<Eigen::Index>(stations[static_cast<std::size_t>(k)]);
    own[k] = independent[i] * independent[i];
    if (factors.rows() > 0) shared.col(k) = factors.col(i);
  }
  Eigen::MatrixXd covariance = shared.transpose() * shared;
  covariance.diagonal() += own;
  return covariance;
}

StationCovariance independentCovariance(const std::vector<Station>& stations) {
  const auto count = static_cast<Eigen::Index>(stations.size());
  StationCovariance covariance;
  covariance.independent.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) covariance.independent[i] = stations[static_cast<std::size_t>(i)].sigma_z;
  covariance.factors.resize(0, count);
  return covariance;
}

bool fits(const StationCovariance& covariance, const std::vector<Station>& stations) {
  if (covariance.empty()) return true;
  const auto count = static_cast<Eigen::Index>(stations.size());
  if (covariance.independent.size() != count) return false;
  return covariance.factors.rows() == 0 || (covariance.factors.cols() == count && covariance.factors.allFinite());
}

}  // namespace tank_datum
