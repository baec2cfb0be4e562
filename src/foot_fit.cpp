#include "tank_datum/foot_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tank_datum/statistics.h"
#include "units.h"

namespace tank_datum {

FootRing::FootRing(const PolarRing& ring, const ShellModel& shell, double side, double reach) {
  const std::vector<PolarPoint>& points = ring.points();
  std::vector<double> radii(points.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < points.size(); ++i) radii[i] = shell.at(points[i].azimuth);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = side * (points[i].radius - radii[i]);
    if (d > -0.1 * reach && d < reach) entries_.push_back({points[i].azimuth, radii[i], d, points[i].z});
  }
}

std::vector<FootPoint> FootRing::around(double azimuth, double half_width, double z, double height) const {
  std::vector<FootPoint> points;
  for (const double shift : {-kTwoPi, 0.0, kTwoPi}) {
    const double from = azimuth + shift - half_width, to = azimuth + shift + half_width;
    auto at = std::lower_bound(entries_.begin(), entries_.end(), from,
                               [](const Entry& e, double value) { return e.azimuth < value; });
    for (; at != entries_.end() && at->azimuth <= to; ++at) {
      if (std::abs(at->z - z) < height) points.push_back({(at->azimuth - azimuth - shift) * at->radius, at->d, at->z});
    }
  }
  return points;
}

namespace {

/// How far the elevation may be off because points were chosen by a d that is as noisy as their z: along a grazing beam
/// both err together, and a row of the scan close to an end of the band is cut on that side alone.
/// @param d,z  of the points used, z without the fit [m]
double selectionError(const std::vector<double>& d, const std::vector<double>& z, const std::vector<double>& weights,
                      double from, double to) {
  double sum = 0, mean_d = 0, mean_z = 0, squares = 0, products = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    sum += weights[i];
    mean_d += weights[i] * d[i];
    mean_z += weights[i] * z[i];
  }
  mean_d /= sum;
  mean_z /= sum;
  for (std::size_t i = 0; i < d.size(); ++i) {
    squares += weights[i] * (d[i] - mean_d) * (d[i] - mean_d);
    products += weights[i] * (d[i] - mean_d) * (z[i] - mean_z);
  }
  if (!(squares > 0.0)) return 0.0;
  const double spread = std::sqrt(squares / sum), to_end = std::min(mean_d - from, to - mean_d) / spread;
  return std::abs(products / squares) * spread * std::exp(-0.5 * to_end * to_end);
}

}  // namespace

FootFit fitFoot(const std::vector<FootPoint>& points, const FootProfile& profile, double start, double slope,
                const FootPrior& prior) {
  constexpr double kSteepestSettlement = 0.01;  // of the datum along the shell [m/m]
  constexpr double kPooled = 10.0;  // how many points the noise of the whole ring counts for beside a station's own
  FootFit fit;
  const auto on_surface = [&](const FootPoint& p) {
    return p.d >= profile.band_from && p.d <= profile.edge &&
           std::abs(p.z - start - profile.slope * p.d) <= 8.0 * profile.noise + profile.blur;
  };
  double seen_to = 0;  // a shadow may end the surface before its edge does
  for (const FootPoint& p : points) {
    if (on_surface(p)) seen_to = std::max(seen_to, p.d);
  }
  const double to = std::min(profile.band_to, seen_to - profile.blur);
  std::vector<Eigen::Vector4d> rows;
  std::vector<double> heights;
  for (const FootPoint& p : points) {
    if (p.d > to || !on_surface(p)) continue;
    rows.emplace_back(1.0, p.d, p.t, p.t * p.t);
    heights.push_back(p.z);
  }
  fit.points = rows.size();
  if (rows.size() < 4) return fit;
  std::vector<double> weights(rows.size(), 1.0), residuals(rows.size());
  double noise = profile.noise;
  Eigen::Vector4d solution(start, slope, 0.0, 0.0);
  Eigen::Matrix4d inverse;
  for (int iteration = 0; iteration < 8; ++iteration) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d rhs = Eigen::Vector4d::Zero();
    double used = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      normal += weights[i] * rows[i] * rows[i].transpose();
      rhs += weights[i] * heights[i] * rows[i];
      used += weights[i];
    }
    const auto belief = [&](double sigma) { return noise * noise / (sigma * sigma); };
    normal(1, 1) += belief(prior.sigma_slope);
    rhs[1] += belief(prior.sigma_slope) * slope;
    normal(2, 2) += belief(kSteepestSettlement);
    normal(3, 3) += belief(prior.sigma_bend);
    if (used < 3.0) return fit;
    inverse = normal.inverse();
    solution = inverse * rhs;
    for (std::size_t i = 0; i < rows.size(); ++i) residuals[i] = heights[i] - rows[i].dot(solution);
    const double own = std::max(robustSigma(residuals, 0.0), 1e-7);
    noise = std::sqrt((kPooled * profile.noise * profile.noise + used * own * own) / (kPooled + used));
    for (std::size_t i = 0; i < rows.size(); ++i) weights[i] = tukeyWeight(residuals[i] / noise);
  }
  fit.z = solution[0];
  fit.slope = solution[1];
  fit.along = solution[2];
  fit.bend = solution[3];
  std::vector<double> d;
  for (const auto& row : rows) d.push_back(row[1]);
  fit.sigma =
      std::hypot(noise * std::sqrt(inverse(0, 0)), selectionError(d, residuals, weights, profile.band_from, to));
  fit.sigma_slope = noise * std::sqrt(inverse(1, 1));
  fit.noise = noise;
  return fit;
}

}  // namespace tank_datum
