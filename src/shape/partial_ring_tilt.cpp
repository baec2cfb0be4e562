#include "shape/partial_ring_tilt.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "shape/datum_waves.h"
#include "shape/out_of_plane.h"
#include "shape/ring_doubts.h"
#include "shape/ring_model.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

bool isMeasured(const Station& s) { return s.flag == StationFlag::Measured; }

/// Covariance of the errors of a plane that is fitted to the elevations by `fit` (3 x stations), about the model's
/// datum: coefficients 1, cos, sin.
Eigen::Matrix3d errorOf(const Eigen::MatrixXd& fit, const RingModel& model) {
  const RingData& data = model.data();
  const Eigen::MatrixXd rows = harmonicRows(data.azimuths, model.order());
  Eigen::MatrixXd waves = model.covariance().bottomRightCorner(rows.cols() - 3, rows.cols() - 3);
  const Eigen::VectorXd mean = model.coefficients().tail(rows.cols() - 3);
  waves += mean * mean.transpose();
  const Eigen::MatrixXd leaked = fit * rows.rightCols(rows.cols() - 3);
  const Eigen::MatrixXd errors = fit * rows * model.neighbourVariances().cwiseSqrt().asDiagonal();
  const Eigen::MatrixXd own = fit * (model.noise().scale * data.sigmas).asDiagonal();
  const Eigen::MatrixXd shared = fit * data.shared.transpose();
  return leaked * waves * leaked.transpose() + errors * errors.transpose() + own * own.transpose() +
         shared * shared.transpose();
}

/// What gaps leave unknown of the plane in which something was refused that may be the datum nevertheless: it is the
/// one or the other, which is half of what they differ by. Coefficients 1, cos, sin of the direction.
Eigen::Matrix3d refusedIn(std::vector<Station> stations, const RingModel& model) {
  if (std::none_of(stations.begin(), stations.end(), isInDoubt)) return Eigen::Matrix3d::Zero();
  std::sort(stations.begin(), stations.end(),
            [](const Station& a, const Station& b) { return a.direction < b.direction; });
  Eigen::VectorXd directions(static_cast<Eigen::Index>(stations.size()));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    directions[static_cast<Eigen::Index>(i)] = stations[i].azimuth = stations[i].direction;
  }
  const Eigen::VectorXd sure = Eigen::VectorXd::Constant(directions.size(), std::numeric_limits<double>::infinity());
  const RingDoubts refused(stations, model.rowsAt(directions) * model.coefficients(), sure);
  const Eigen::MatrixXd moved = 0.5 * refused.waves(1);
  return moved * moved.transpose();
}

}  // namespace

bool hasTiltingGap(const std::vector<Station>& stations) {
  constexpr double kHarmless = 6.0 * kPi / 180.0, kUsual = 2.5;  // in spacings of stations all round
  const auto count = static_cast<double>(std::count_if(stations.begin(), stations.end(), isMeasured));
  return longestGap(stations, 1.0) > std::max(kHarmless, kUsual * kTwoPi / count);
}

PlaneFit fitPlane(const std::vector<Station>& stations, const Eigen::Vector2d& center,
                  const StationCovariance& covariance) {
  const auto count = std::count_if(stations.begin(), stations.end(), isMeasured);
  Eigen::MatrixXd rows(count, 3);
  Eigen::Index i = 0;
  for (const Station& s : stations) {
    if (isMeasured(s)) rows.row(i++) << 1.0, s.x - center.x(), s.y - center.y();
  }
  const double radius = std::sqrt(rows.rightCols<2>().squaredNorm() / static_cast<double>(count));
  RingData data = ringData(stations, radius, covariance);
  for (i = 0; i < count; ++i) data.azimuths[i] = portable::atan2(rows(i, 2), rows(i, 1));
  const RingModel model(data);
  const Eigen::Vector3d scales(1.0, 1.0 / radius, 1.0 / radius);
  PlaneFit fit;
  fit.freedom = model.noise().freedom;
  Eigen::Matrix3d errors;  // covariance of coefficients 1, cos, sin
  if (model.dense() || hasTiltingGap(stations)) {
    fit.plane = scales.cwiseProduct(model.coefficients().head<3>());
    errors = model.covariance().topLeftCorner<3, 3>();
  } else {
    const std::vector<double> weights = waveData(stations, 1).weights;
    const Eigen::MatrixXd weighted =
        rows.transpose() * Eigen::Map<const Eigen::VectorXd>(weights.data(), data.count()).asDiagonal();
    const Eigen::MatrixXd solution = (weighted * rows).ldlt().solve(weighted);
    fit.plane = solution * data.z;
    errors = errorOf(scales.cwiseInverse().asDiagonal() * solution, model);
  }
  errors += refusedIn(stations, model);
  fit.covariance = scales.asDiagonal() * errors * scales.asDiagonal();
  return fit;
}

}  // namespace tank_datum
