#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/fit/curves.h"

namespace tank_datum {

/// The row (1, cos t, sin t, cos 2t, ...) of the design matrix.
Eigen::RowVectorXd harmonicRow(double azimuth, int order);
/// Such rows at azimuths [rad].
Eigen::MatrixXd harmonicRows(const Eigen::VectorXd& azimuths, int order);

/// How harmonics are fitted.
struct HarmonicFit {
  int order = 1;        ///< highest
  bool robust = false;  ///< iteratively reweighted by Tukey's biweight
  double ridge = 0.0;   ///< weight, as a share of the data's, that draws the n-th harmonic to zero with (n / order)^4
                        ///< and so keeps the function quiet across gaps
};

/// Weighted least squares.
/// @param azimuths  [rad]
/// @param weights   one per value, or empty for 1
PeriodicFit fitHarmonics(const std::vector<double>& azimuths, const std::vector<double>& values,
                         const std::vector<double>& weights, const HarmonicFit& how);

}  // namespace tank_datum
