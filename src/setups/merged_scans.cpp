#include "setups/merged_scans.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "setups/double_surface.h"
#include "setups/setup_system.h"
#include "setups/shell_arcs.h"

namespace tank_datum {

double mergedSigma(const Ring& ring, const Tank& tank, double discrepancy, double given, double noise) {
  constexpr double kUsual = 0.0022;   // a setup's height known to 2 mm and its tilt to 10 arc-seconds, 20 m away [m]
  constexpr double kDifferences = 5;  // that six scans round a tank tell
  constexpr double kUnseen = 0.5;     // of the noise: two levels up to three times as far apart as it look like one
  if (discrepancy > 0.0) return temperedSigma(discrepancy / std::sqrt(2.0), kDifferences, given > 0.0 ? given : kUsual);
  if (!isSeenBySeveral(shellArcs(ring, tank), tank)) return 0.0;
  return given > 0.0 ? given : std::max(assumedSigma(kUsual), kUnseen * noise);
}

void judgeMerged(SetupAgreement& agreement, const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                 const Eigen::Vector2d& center, const FoundationBand& band) {
  agreement.unlabelled_discrepancy = std::sqrt(2.0) * doubleDisagreement(ring, tank, stations, center, band);
  agreement.merged_sigma =
      mergedSigma(ring, tank, agreement.unlabelled_discrepancy, agreement.given.height, band.noise);
}

Eigen::MatrixXd mergedFactors(const std::vector<Station>& stations, double sigma) {
  constexpr int kWaves = 6;
  constexpr double kLength = 0.5;  // along which errors are alike [rad]
  double total = 0.0;
  for (int n = 0; n <= kWaves; ++n) total += portable::exp(-0.5 * n * n * kLength * kLength) * (n == 0 ? 0.5 : 1.0);
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(2 * kWaves + 1, static_cast<Eigen::Index>(stations.size()));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!std::isfinite(stations[i].z)) continue;
    const auto column = static_cast<Eigen::Index>(i);
    for (int n = 0; n <= kWaves; ++n) {
      const double size =
          sigma * std::sqrt(portable::exp(-0.5 * n * n * kLength * kLength) * (n == 0 ? 0.5 : 1.0) / total);
      const double angle = n * stations[i].direction;
      factors(n == 0 ? 0 : 2 * n - 1, column) = size * portable::cos(angle);
      if (n > 0) factors(2 * n, column) = size * portable::sin(angle);
    }
  }
  return factors;
}

}  // namespace tank_datum
