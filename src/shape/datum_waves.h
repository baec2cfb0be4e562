#pragma once

#include <vector>

#include "tank_datum/fit/curves.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The measured stations as the regressions use them.
struct WaveData {
  std::vector<double> azimuths;  ///< as the user counts them [rad]
  std::vector<double> z;         ///< [m]
  std::vector<double> sigmas;    ///< [m]; empty when not all are known
  std::vector<double> weights;   ///< 1 / (sigma^2 + excess^2), or 1

  std::size_t count() const { return z.size(); }
};

/// Measured stations with weights. The excess is what scatters about a fit of `order` beyond the standard errors
/// (Mandel and Paule 1970).
WaveData waveData(const std::vector<Station>& stations, int order);

/// Whether the stations' places tell the waves up to `order` apart: no coefficient has more than five times the
/// standard error that stations all round would give.
bool tellsApart(const WaveData& data, int order);

/// The highest order up to `wanted` that the stations' places tell apart, with four stations a wave. At least `least`.
int highestOrder(const WaveData& data, int wanted, int least);

/// What the variances that a fit of `order` promises must be multiplied by: the power that its residuals [m] have in
/// the waves next above, which noise shared by neighbours raises, and no less than what the weights say.
double noiseFactor(const WaveData& data, const std::vector<double>& residuals, int order);

/// Weighted least squares of all waves up to `order`. The covariance is multiplied by noiseFactor.
PeriodicFit fitWaves(const WaveData& data, int order);

/// Weighted sum of squares of what a fit leaves.
double residualSum(const WaveData& data, const PeriodicFit& fit);

}  // namespace tank_datum
