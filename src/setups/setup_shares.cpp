#include "setups/setup_shares.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"
#include "setups/merged_scans.h"
#include "setups/station_cells.h"
#include "stations/station_covariance.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kSeen = 0.01;  // share of a station's points from which on a setup is said to see it

/// Points of each setup in equal cells of azimuth, the stations standing in the middle of some of them.
class CellCounts {
 public:
  /// @param center  about which the stations stand [m]
  CellCounts(const Ring& ring, Side side, const std::vector<Station>& stations, const Eigen::Vector2d& center,
             const FoundationBand& band);

  /// Adds those within half a window of a cell's middle.
  void add(std::size_t cell, double half_window, Eigen::Ref<Eigen::RowVectorXd> foundation,
           Eigen::Ref<Eigen::RowVectorXd> shell) const;
  std::size_t cellOf(double direction) const { return cells_.cellOf(direction); }

 private:
  StationCells cells_;
  Eigen::MatrixXd foundation_, shell_;  // [cells x setups]
};

CellCounts::CellCounts(const Ring& ring, Side side, const std::vector<Station>& stations, const Eigen::Vector2d& center,
                       const FoundationBand& band)
    : cells_(stations) {
  constexpr double kShellFrom = 0.1;  // above the datum [reach]
  const double near = band.tolerance(ring.reach);
  foundation_ = shell_ =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cells_.count()), static_cast<Eigen::Index>(ring.setupCount()));
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const auto [cell, azimuth, d, h] = cells_.placeOf(ring.points[i], center, side);
    const auto row = static_cast<Eigen::Index>(cell), column = static_cast<Eigen::Index>(ring.setupOf(i));
    if (d >= band.from && d <= band.to && std::abs(h - band.slope * d) < near) {
      foundation_(row, column) += 1.0;
    } else if (std::abs(d) < near && h > kShellFrom * ring.reach) {
      shell_(row, column) += 1.0;
    }
  }
}

void CellCounts::add(std::size_t cell, double half_window, Eigen::Ref<Eigen::RowVectorXd> foundation,
                     Eigen::Ref<Eigen::RowVectorXd> shell) const {
  const std::size_t count = cells_.count();
  const auto held = static_cast<std::size_t>(std::max(0.0, std::floor(half_window / cells_.step() + 1e-9)));
  const std::size_t beside = std::min(held, count / 2 - 1);
  for (std::size_t k = 0; k <= 2 * beside; ++k) {
    const auto row = static_cast<Eigen::Index>((cell + count + k - beside) % count);
    foundation += foundation_.row(row);
    shell += shell_.row(row);
  }
}

/// A station none of whose points were counted, an interpolated one or one with few, leans on both sides alike.
void fillBetween(const std::vector<Station>& stations, Eigen::MatrixXd& shares) {
  const std::size_t count = stations.size();
  const Eigen::VectorXd counted = shares.rowwise().sum();
  const auto has = [&counted](std::size_t i) { return counted[static_cast<Eigen::Index>(i)] > 0.0; };
  for (std::size_t i = 0; i < count; ++i) {
    if (stations[i].flag == StationFlag::Missing || has(i)) continue;
    for (const bool up : {false, true}) {
      for (std::size_t away = 1; away < count; ++away) {
        const std::size_t j = (i + (up ? away : count - away)) % count;
        if (!has(j)) continue;
        shares.row(static_cast<Eigen::Index>(i)) += 0.5 * shares.row(static_cast<Eigen::Index>(j));
        break;
      }
    }
  }
}

}  // namespace

double FoundationBand::tolerance(double reach) const {
  constexpr double kNoises = 5.0;
  constexpr double kRoughly = 0.01;  // of the reach
  return kNoises * noise + kRoughly * reach;
}

SetupShares setupShares(const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                        const Eigen::Vector2d& center, const FoundationBand& band) {
  SetupShares shares;
  const auto rows = static_cast<Eigen::Index>(stations.size()), columns = static_cast<Eigen::Index>(ring.setupCount());
  shares.foundation = shares.shell = Eigen::MatrixXd::Zero(rows, columns);
  const CellCounts counts(ring, tank.side, stations, center, band);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Station& s = stations[static_cast<std::size_t>(i)];
    if (s.flag != StationFlag::Measured) continue;
    Eigen::RowVectorXd foundation = Eigen::RowVectorXd::Zero(columns), shell = foundation;
    counts.add(counts.cellOf(s.direction), 0.5 * s.window, foundation, shell);
    if (foundation.sum() > 0.0) shares.foundation.row(i) = foundation / foundation.sum();
    if (shell.sum() > 0.0) shares.shell.row(i) = shell / shell.sum();
  }
  fillBetween(stations, shares.foundation);
  fillBetween(stations, shares.shell);
  return shares;
}

Eigen::MatrixXd setupFactors(const SetupAgreement& agreement, const SetupShares& shares,
                             const std::vector<Station>& stations, double slope) {
  constexpr double kNothing = 1e-6;  // [m]
  const auto count = static_cast<Eigen::Index>(stations.size());
  const Eigen::Index parameters = agreement.covariance.rows();
  if (parameters == 0) return Eigen::MatrixXd(0, count);
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(count, parameters);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Station& station = stations[static_cast<std::size_t>(i)];
    if (!std::isfinite(station.z)) continue;
    for (std::size_t s = 0; s < agreement.setups.size(); ++s) {
      const auto column = static_cast<Eigen::Index>(s);
      const double share = shares.foundation(i, column), sideways = slope * (shares.shell(i, column) - share);
      const Eigen::Vector3d& origin = agreement.setups[s].origin;
      derivatives.block<1, SetupMotion::kParameters>(i, column * SetupMotion::kParameters) << share,
          share * (station.x - origin.x()), share * (station.y - origin.y()),
          sideways * portable::cos(station.direction), sideways * portable::sin(station.direction);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(agreement.covariance);
  const Eigen::MatrixXd roots = own.eigenvectors() * own.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  const Eigen::MatrixXd moved = derivatives * roots;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> turn(moved.transpose() * moved);
  const Eigen::MatrixXd rows = (moved * turn.eigenvectors()).transpose();  // the least first
  Eigen::Index first = 0;
  while (first < parameters && rows.row(first).cwiseAbs().maxCoeff() < kNothing) ++first;
  return rows.bottomRows(parameters - first).colwise().reverse();
}

std::vector<double> setupRadiusErrors(const SetupAgreement& agreement, const SetupShares& shares,
                                      const std::vector<Station>& stations) {
  const auto count = static_cast<Eigen::Index>(stations.size());
  std::vector<double> errors(stations.size(), 0.0);
  if (agreement.merged_sigma > 0.0) std::fill(errors.begin(), errors.end(), agreement.merged_sigma);
  const Eigen::Index parameters = agreement.covariance.rows();
  if (parameters == 0) return errors;
  Eigen::MatrixXd derivatives = Eigen::MatrixXd::Zero(count, parameters), centre = Eigen::MatrixXd::Zero(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Station& station = stations[static_cast<std::size_t>(i)];
    if (!std::isfinite(station.z)) continue;
    const Eigen::RowVector2d outwards(portable::cos(station.direction), portable::sin(station.direction));
    centre.row(i) = outwards;
    for (Eigen::Index s = 0; s < shares.shell.cols(); ++s)
      derivatives.block<1, 2>(i, s * SetupMotion::kParameters + 3) = shares.shell(i, s) * outwards;
  }
  derivatives -= centre * (centre.transpose() * centre).ldlt().solve(centre.transpose() * derivatives);
  const Eigen::VectorXd variances = (derivatives * agreement.covariance).cwiseProduct(derivatives).rowwise().sum();
  for (Eigen::Index i = 0; i < count; ++i) errors[static_cast<std::size_t>(i)] = std::sqrt(std::max(0.0, variances[i]));
  return errors;
}

SharedErrors shareSetupErrors(const SetupAgreement& agreement, const std::vector<Station>& stations,
                              const SetupShares& shares, double slope) {
  SharedErrors shared;
  shared.covariance = independentCovariance(stations);
  shared.covariance.factors = agreement.merged_sigma > 0.0 ? mergedFactors(stations, agreement.merged_sigma)
                                                           : setupFactors(agreement, shares, stations, slope);
  shared.radius_errors = setupRadiusErrors(agreement, shares, stations);
  shared.stations.resize(stations.size());
  shared.seen.resize(agreement.setups.size());
  const bool one_has_points = shares.foundation.cols() == 1;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!std::isfinite(stations[i].z)) continue;
    const auto column = static_cast<Eigen::Index>(i);
    shared.stations[i].sigma_setup = shared.covariance.factors.col(column).norm();
    std::size_t seen = 0;
    for (std::size_t s = 0; s < agreement.setups.size(); ++s) {
      if (one_has_points && agreement.setups[s].points == 0) continue;
      if (shares.foundation(column, one_has_points ? 0 : static_cast<Eigen::Index>(s)) < kSeen) continue;
      ++seen;
      if (stations[i].flag == StationFlag::Measured) shared.seen[s].push_back(i);
    }
    shared.stations[i].n_setups = seen;
  }
  return shared;
}

std::vector<Station> withSharedErrors(std::vector<Station> stations, const SharedErrors& shared) {
  stations = withParts(std::move(stations), shared.stations);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    Station& s = stations[i];
    if (std::isfinite(s.sigma_setup)) s.sigma_z = std::hypot(s.sigma_z, s.sigma_setup);
    s.sigma_radius = std::hypot(s.sigma_radius, shared.radius_errors[i]);
  }
  return stations;
}

}  // namespace tank_datum
