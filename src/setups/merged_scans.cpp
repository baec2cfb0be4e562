#include "setups/merged_scans.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/parts.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "setups/double_surface.h"
#include "setups/setup_ring.h"
#include "setups/setup_system.h"
#include "setups/setup_views.h"

namespace tank_datum {
namespace {

/// A share of the ring's points in their order, each with the number of its visit to its arc as the setup.
Ring visitsOf(const Ring& ring, const Tank& tank, int threads) {
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
  const auto arcs = concatenated(ofParts(visits.points.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> part;
    for (std::size_t i = begin; i < end; ++i) part.push_back(SetupRing::arcOf(visits.points[i], tank.circle.center));
    return part;
  }));
  for (std::size_t i = 0; i < visits.points.size(); ++i) {
    const std::size_t arc = arcs[i];
    if (seen[arc] && i - last[arc] > apart) ++number[arc];
    seen[arc] = true;
    last[arc] = i;
    visits.point_setups.push_back(static_cast<std::uint16_t>(std::min(number[arc], kMostVisits)));
  }
  visits.setups.resize(1 + std::min(kMostVisits, *std::max_element(number.begin(), number.end())));
  return visits;
}

/// Variance of an arc's offsets.
struct ArcVariance {
  double excess;   ///< beyond what noise makes, for one scan [m^2]
  double noise;    ///< what noise makes [m^2]
  double degrees;  ///< of freedom
};

ArcVariance varianceOf(const ArcOffsets& seen) {
  constexpr double kLeastNoise = 1e-16;  // of points without noise, beyond what rounding leaves [m^2]
  const auto count = static_cast<Eigen::Index>(seen.setups.size());
  const auto degrees = static_cast<double>(count - 1);
  // the common height is not in the information: held, and taken out of the covariance again
  const double gauge = seen.information.trace() / static_cast<double>(count * count);
  const Eigen::MatrixXd held = seen.information + Eigen::MatrixXd::Constant(count, count, gauge);
  const double noise =
      held.ldlt().solve(Eigen::MatrixXd::Identity(count, count)).trace() - 1.0 / (gauge * static_cast<double>(count));
  return {(seen.offsets.squaredNorm() - noise) / degrees, std::max(noise / degrees, kLeastNoise), degrees};
}

/// Whether an arc's offsets are beyond what noise makes, by so many deviates of a normal distribution.
bool isBeyondNoise(const ArcVariance& arc, double deviate) {
  return arc.degrees * (arc.excess / arc.noise + 1.0) > chiSquareQuantile(arc.degrees, deviate);
}

/// The arcs without those in which scans seem to disagree where they do not in the arcs seen on either side: two scans
/// overlap over more than an arc, plants and things do not.
std::vector<ArcVariance> withoutLoneArcs(const std::vector<ArcVariance>& arcs) {
  constexpr double kClearly = 3.0, kHardly = 1.645;  // deviates
  std::vector<ArcVariance> kept;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const bool beside = isBeyondNoise(arcs[(i + arcs.size() - 1) % arcs.size()], kHardly) ||
                        isBeyondNoise(arcs[(i + 1) % arcs.size()], kHardly);
    if (beside || !isBeyondNoise(arcs[i], kClearly)) kept.push_back(arcs[i]);
  }
  return kept;
}

/// The excess that the arcs have in common [m^2], each by what it knows of it: the variance of a variance of normal
/// values is twice its square over the degrees of freedom. None where noise alone may make it.
double commonExcess(const std::vector<ArcVariance>& arcs) {
  constexpr int kSteps = 20;
  constexpr double kPlain = 3.0;  // standard errors
  double excess = 0.0, known = 0.0;
  for (const ArcVariance& arc : arcs) known += 0.5 * arc.degrees / (arc.noise * arc.noise);
  for (int step = 0; step < kSteps; ++step) {
    double sum = 0.0, weights = 0.0;
    for (const ArcVariance& arc : arcs) {
      const double variance = std::max(0.0, excess) + arc.noise, weight = arc.degrees / (variance * variance);
      sum += weight * arc.excess;
      weights += weight;
    }
    excess = sum / weights;
  }
  return excess > kPlain / std::sqrt(known) ? excess : 0.0;
}

/// Whether more of the shell is seen than one setup sees: from outside it is never half of it.
bool isSeenBySeveral(const Ring& ring, const Tank& tank) {
  constexpr double kFrom = 0.3, kNear = 0.2;  // of the reach: above the foot, and off the circle
  constexpr std::size_t kFewestPoints = 5;    // of an arc
  constexpr std::size_t kAllowance = 4;       // arcs: shells are not round, their centres not known
  if (tank.side != Side::Outside) return false;
  std::vector<std::size_t> counts(SetupRing::kArcs, 0);
  for (const Eigen::Vector3d& p : ring.points) {
    const Eigen::Vector2d arm = p.head<2>() - tank.circle.center;
    if (std::abs(arm.norm() - tank.circle.radius) > kNear * ring.reach) continue;
    if (p.z() > tank.foot(portable::atan2(arm.y(), arm.x())) + kFrom * ring.reach) {
      ++counts[SetupRing::arcOf(p, tank.circle.center)];
    }
  }
  const auto seen = std::count_if(counts.begin(), counts.end(), [](std::size_t n) { return n >= kFewestPoints; });
  return static_cast<std::size_t>(seen) > SetupRing::kArcs / 2 + kAllowance;
}

}  // namespace

double mergedDisagreement(const Ring& ring, const Tank& tank, int threads) {
  constexpr std::size_t kFewestArcs = 6;  // arcs
  constexpr double kOther = 25.0;         // times the median: an arc where something else is seen
  constexpr double kBank = 0.15;          // fall of a surface that looks another from each place [m/m]
  if (ring.points.size() < 1000 || ring.setupCount() > 1) return 0.0;
  const Ring visits = visitsOf(ring, tank, threads);
  if (visits.setups.size() < 2) return 0.0;
  const SetupRing polar(visits, tank, threads);
  const std::vector<Eigen::Vector3d> origins(visits.setups.size(), Eigen::Vector3d::Zero());
  std::vector<ArcVariance> variances, usual;
  std::vector<double> sizes;
  for (const ArcView& view : viewArcs(polar, tank, ring.reach, origins, threads)) {
    if (view.shell || view.fall > kBank) continue;
    variances.push_back(varianceOf(view.seen));
    sizes.push_back(std::abs(variances.back().excess));
  }
  if (variances.size() < kFewestArcs) return 0.0;
  const double most = kOther * median(sizes);
  for (const ArcVariance& v : variances) {
    if (v.excess <= most) usual.push_back(v);
  }
  return std::sqrt(commonExcess(withoutLoneArcs(usual)));
}

double mergedSigma(const Ring& ring, const Tank& tank, double discrepancy, double given) {
  constexpr double kUsual = 0.0022;   // a setup's height known to 2 mm and its tilt to 10 arc-seconds, 20 m away [m]
  constexpr double kDifferences = 5;  // that six scans round a tank tell
  const double usual = given > 0.0 ? given : kUsual;
  if (discrepancy > 0.0) return temperedSigma(discrepancy / std::sqrt(2.0), kDifferences, usual);
  return isSeenBySeveral(ring, tank) ? usual : 0.0;
}

void judgeMerged(SetupAgreement& agreement, const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                 const Eigen::Vector2d& center, const FoundationBand& band) {
  const double doubled = doubleDisagreement(ring, tank, stations, center, band);
  agreement.unlabelled_discrepancy = std::max(agreement.unlabelled_discrepancy, std::sqrt(2.0) * doubled);
  agreement.merged_sigma = mergedSigma(ring, tank, agreement.unlabelled_discrepancy, agreement.given.height);
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
