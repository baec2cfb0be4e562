#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/fit/curves.h"

namespace tank_datum {

/// The row (1, cos t, sin t, cos 2t, ...) of the design matrix.
Eigen::RowVectorXd harmonicRow(double azimuth, int order);

/// Weighted least squares; with `robust`, iteratively reweighted by Tukey's biweight.
/// @param weights  one per value, or empty for 1
/// @param ridge    weight, as a share of the data's, that draws the n-th harmonic to zero with (n / order)^4 and so
///                 keeps the function quiet across gaps
PeriodicFit fitHarmonics(const std::vector<double>& azimuths, const std::vector<double>& values,
                         const std::vector<double>& weights, int order, bool robust, double ridge);

}  // namespace tank_datum
