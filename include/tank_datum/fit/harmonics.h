#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A periodic function a0 + sum over n of a_n cos(n t) + b_n sin(n t); empty until fitted.
struct PeriodicFit {
  Eigen::VectorXd coefficients;  ///< a0, a1, b1, a2, b2, ...
  Eigen::MatrixXd covariance;    ///< of the coefficients, from the weights as given
  double sigma = 0.0;            ///< robust standard deviation of the residuals

  bool valid() const { return coefficients.size() > 0; }
  int order() const { return static_cast<int>(coefficients.size() / 2); }
  double operator()(double azimuth) const;
};

/// The row (1, cos t, sin t, cos 2t, ...) of the design matrix.
Eigen::RowVectorXd harmonicRow(double azimuth, int order);

/// Weighted least squares; with `robust`, iteratively reweighted by Tukey's biweight.
/// @param weights  one per value, or empty for 1
/// @param ridge    weight, as a share of the data's, that draws the n-th harmonic to zero with (n / order)^4 and so
///                 keeps the function quiet across gaps
PeriodicFit fitHarmonics(const std::vector<double>& azimuths, const std::vector<double>& values,
                         const std::vector<double>& weights, int order, bool robust, double ridge);

}  // namespace tank_datum
