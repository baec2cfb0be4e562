#include "setups/merged_scans.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "setups/setup_ring.h"
#include "setups/setup_views.h"

namespace tank_datum {
namespace {

/// A share of the ring's points in their order, each with the number of its visit to its arc as the setup.
Ring visitsOf(const Ring& ring, const Tank& tank) {
  constexpr std::size_t kLookedAt = 800'000;
  constexpr double kApart = 0.005;         // of all points between two visits of an arc
  constexpr std::size_t kMostVisits = 12;  // more are rows of one scan, not scans
  const std::size_t every = ring.points.size() / kLookedAt + 1;
  Ring visits;
  visits.reach = ring.reach;
  for (std::size_t i = 0; i < ring.points.size(); i += every) visits.points.push_back(ring.points[i]);
  const auto apart = static_cast<std::size_t>(kApart * static_cast<double>(visits.points.size()));
  std::vector<std::size_t> last(SetupRing::kArcs, 0), number(SetupRing::kArcs, 0);
  std::vector<bool> seen(SetupRing::kArcs, false);
  for (std::size_t i = 0; i < visits.points.size(); ++i) {
    const Eigen::Vector2d arm = visits.points[i].head<2>() - tank.circle.center;
    const double turn = std::atan2(arm.y(), arm.x()) / kTwoPi;
    const auto arc =
        std::min(SetupRing::kArcs - 1, static_cast<std::size_t>((turn - std::floor(turn)) * SetupRing::kArcs));
    if (seen[arc] && i - last[arc] > apart) ++number[arc];
    seen[arc] = true;
    last[arc] = i;
    visits.point_setups.push_back(static_cast<std::uint16_t>(std::min(number[arc], kMostVisits)));
  }
  visits.setups.resize(1 + std::min(kMostVisits, *std::max_element(number.begin(), number.end())));
  return visits;
}

/// Variance of an arc's offsets beyond their noise, for one scan.
double varianceOf(const ArcOffsets& seen) {
  const auto count = static_cast<Eigen::Index>(seen.setups.size());
  // the common height is not in the information: held, and taken out of the covariance again
  const double gauge = seen.information.trace() / static_cast<double>(count * count);
  const Eigen::MatrixXd held = seen.information + Eigen::MatrixXd::Constant(count, count, gauge);
  const double noise =
      held.ldlt().solve(Eigen::MatrixXd::Identity(count, count)).trace() - 1.0 / (gauge * static_cast<double>(count));
  return (seen.offsets.squaredNorm() - noise) / static_cast<double>(count - 1);
}

}  // namespace

double mergedDisagreement(const Ring& ring, const Tank& tank, int threads) {
  constexpr std::size_t kFewestArcs = 6;  // arcs
  constexpr double kOther = 25.0;         // times the median: an arc where something else is seen
  if (ring.points.size() < 1000 || ring.setupCount() > 1) return 0.0;
  const Ring visits = visitsOf(ring, tank);
  if (visits.setups.size() < 2) return 0.0;
  const SetupRing polar(visits, tank, threads);
  const std::vector<Eigen::Vector3d> origins(visits.setups.size(), Eigen::Vector3d::Zero());
  std::vector<double> variances, sizes;
  for (const ArcView& view : viewArcs(polar, tank, ring.reach, origins, threads)) {
    if (view.shell) continue;
    variances.push_back(varianceOf(view.seen));
    sizes.push_back(std::abs(variances.back()));
  }
  if (variances.size() < kFewestArcs) return 0.0;
  const double most = kOther * median(sizes);
  double sum = 0.0, count = 0.0;
  for (const double v : variances) {
    if (v > most) continue;
    sum += v;
    count += 1.0;
  }
  const double mean = sum / count;
  return mean > 0.0 ? std::sqrt(mean) : 0.0;
}

Eigen::MatrixXd mergedFactors(const std::vector<Station>& stations, double sigma) {
  constexpr int kWaves = 6;
  constexpr double kLength = 0.5;  // along which errors are alike [rad]
  double total = 0.0;
  for (int n = 0; n <= kWaves; ++n) total += std::exp(-0.5 * n * n * kLength * kLength) * (n == 0 ? 0.5 : 1.0);
  Eigen::MatrixXd factors = Eigen::MatrixXd::Zero(2 * kWaves + 1, static_cast<Eigen::Index>(stations.size()));
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!std::isfinite(stations[i].z)) continue;
    const auto column = static_cast<Eigen::Index>(i);
    for (int n = 0; n <= kWaves; ++n) {
      const double size = sigma * std::sqrt(std::exp(-0.5 * n * n * kLength * kLength) * (n == 0 ? 0.5 : 1.0) / total);
      const double angle = n * stations[i].direction;
      factors(n == 0 ? 0 : 2 * n - 1, column) = size * std::cos(angle);
      if (n > 0) factors(2 * n, column) = size * std::sin(angle);
    }
  }
  return factors;
}

}  // namespace tank_datum
