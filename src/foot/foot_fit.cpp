#include "foot/foot_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "fit/surface_rows.h"
#include "foot/foot_profile.h"

namespace tank_datum {

FootRing::FootRing(PolarRing ring, const ShellModel& shell, double side, double reach)
    : entries_(ring.points().size()), behind_(-0.1 * reach) {
  forEachRun(entries_.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const PolarPoint& p = ring.points()[i];
      const double radius = shell.at(p.azimuth);
      entries_[i] = {p.azimuth, radius, side * (p.radius - radius), p.z};
    }
  });
  const auto is_far = [reach](const Entry& e) { return !(std::abs(e.d) < reach); };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), is_far), entries_.end());
}

std::vector<FootPoint> FootRing::around(double azimuth, double half_width, double z, double height) const {
  std::size_t count = 0;
  visitAround(azimuth, half_width, z, height, [&count](const FootPoint&) { ++count; });
  std::vector<FootPoint> points;
  points.reserve(count);
  visitAround(azimuth, half_width, z, height, [&points](const FootPoint& p) { points.push_back(p); });
  return points;
}

std::pair<std::size_t, std::size_t> FootRing::between(double from, double to) const {
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), from,
                                      [](const Entry& e, double value) { return e.azimuth < value; });
  const auto last =
      std::upper_bound(first, entries_.end(), to, [](double value, const Entry& e) { return value < e.azimuth; });
  return {static_cast<std::size_t>(first - entries_.begin()), static_cast<std::size_t>(last - entries_.begin())};
}

namespace {

/// How far a fit's points lie from the shell, by their weights.
struct Distances {
  double weights = 0, mean = 0, squares = 0;  ///< squares about the mean

  explicit Distances(const SurfaceRows& rows) {
    const std::vector<double>&d = rows.a(), &w = rows.weights();
    for (std::size_t i = 0; i < rows.size(); ++i) weights += w[i], mean += w[i] * d[i];
    mean /= weights;
    for (std::size_t i = 0; i < rows.size(); ++i) squares += w[i] * (d[i] - mean) * (d[i] - mean);
  }
  double spread() const { return std::sqrt(squares / weights); }
};

/// The share of a sum of squares that some terms of a fit explain, less what they explain by chance (adjusted
/// coefficient of determination).
double shareExplained(double explained, double all, double points, double terms) {
  const double free = points - 1.0 - terms;
  if (!(all > 0.0) || !(free > 0.0)) return 1.0;
  return std::max(0.0, 1.0 - (1.0 - explained / all) * (points - 1.0) / free);
}

/// Slopes that one row of a scan may feign, about the middle of its points. Its rays meet the bumps of a rough surface
/// farther out: all its points lie in the rays' own plane, and a fit through them is as good as that plane is steep.
struct FeignedSlopes {
  Eigen::Matrix<double, 4, 2> terms;  ///< of the fit, for one across the shell and one along it
  double row = 0.0;                   ///< share by which the points are one row
  double across = 0.0, along = 0.0;   ///< standard deviations [m/m]

  /// @param hidden  variance of points about the surface that the fit does not show [m^2]
  FeignedSlopes(const SurfaceRows::Equations& sums, double hidden) {
    const double n = sums.weight;
    const Eigen::Vector3d mean = sums.matrix.col(0).tail<3>() / n;  // of d, t and t^2
    const Eigen::Matrix3d about = sums.matrix.bottomRightCorner<3, 3>() - n * mean * mean.transpose();
    terms << -mean[0], -mean[1], 1.0, 0.0, 0.0, 1.0, 0.0, 0.0;
    const Eigen::Vector2d with_t = about.col(0).tail<2>();
    row = shareExplained(with_t.dot(about.bottomRightCorner<2, 2>().ldlt().solve(with_t)), about(0, 0), n, 2.0);
    const double by_d = about(0, 0) > 0.0 ? square(about(0, 1)) / about(0, 0) : 0.0;
    across = feigned(hidden, std::max(0.0, about(0, 0)) / n, row);
    along = feigned(hidden, std::max(0.0, about(1, 1)) / n, shareExplained(by_d, about(1, 1), n, 1.0));
  }

 private:
  /// @param explained  share of the variance by which the points are one row
  static double feigned(double hidden, double variance, double explained) {
    constexpr double kNone = 1e-9;
    return std::max(kNone, std::sqrt(hidden * explained / (variance * (1.0 - explained))));
  }
};

/// The points on the surface that a fit goes through, between two distances from the shell [m].
struct BandRows {
  SurfaceRows rows;
  double from, to;
};

/// Sums of what beams lift points by, as of the right side of the weighted normal equations.
Eigen::Vector4d liftsOf(const BandRows& band, const BeamEffects& beams) {
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  if (!beams.reach(band.from)) return sums;
  const SurfaceRows& rows = band.rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double d = rows.a()[i], t = rows.t()[i];
    sums += rows.weights()[i] * beams.liftAt(d) * Eigen::Vector4d(1.0, d, t, t * t);
  }
  return sums;
}

/// How far the elevation may be off because points were chosen by a d that is as noisy as their z: along a grazing beam
/// both err together, and a row of the scan close to an end of the band is cut on that side alone.
/// @param band  a is d, the residuals are z without the fit
double selectionError(const BandRows& band, const Distances& distances) {
  const SurfaceRows& rows = band.rows;
  const std::vector<double>&d = rows.a(), &z = rows.residuals(), &weights = rows.weights();
  if (!(distances.squares > 0.0)) return 0.0;
  double mean_z = 0, products = 0;
  for (std::size_t i = 0; i < d.size(); ++i) mean_z += weights[i] * z[i];
  mean_z /= distances.weights;
  for (std::size_t i = 0; i < d.size(); ++i) products += weights[i] * (d[i] - distances.mean) * (z[i] - mean_z);
  const double spread = distances.spread(),
               to_end = std::min(distances.mean - band.from, band.to - distances.mean) / spread;
  return std::abs(products / distances.squares) * spread * portable::exp(-0.5 * to_end * to_end);
}

/// The points on the surface that a fit looks at, up to where the surface or what is seen of it ends.
/// @param from    where they begin [m]
/// @param lifted  what is taken out of them
BandRows rowsOnSurface(const std::vector<FootPoint>& points, const FootProfile& profile, double start, double from,
                       const BeamEffects& lifted) {
  const auto on_surface = [&](const FootPoint& p) {
    return p.d >= from && p.d <= profile.edge && fitsLevel(p, start, profile);
  };
  double seen_to = 0;  // a shadow may end the surface before its edge does
  for (const FootPoint& p : points) {
    if (on_surface(p)) seen_to = std::max(seen_to, p.d);
  }
  BandRows band{{}, from, std::min(profile.band_to, seen_to - profile.blur)};
  band.rows.reserve(points.size());
  for (const FootPoint& p : points) {
    if (p.d <= band.to && on_surface(p)) band.rows.add(p.d, p.t, p.z - lifted.liftAt(p.d));
  }
  band.rows.close();
  return band;
}

/// How well points tell a slope.
struct Told {
  double points, spread;

  explicit Told(const SurfaceRows& rows)
      : points(static_cast<double>(rows.size())), spread(points > 0.0 ? Distances(rows).spread() : 0.0) {}
  bool nearlyAs(const Told& all) const {
    constexpr double kMost = 0.5;
    return points > kMost * all.points && spread > kMost * all.spread;
  }
};

FootFit fitBand(BandRows band, const FootProfile& profile, const FootPrior& prior) {
  constexpr double kSteepestSettlement = 0.01;  // of the datum along the shell [m/m]
  constexpr double kPooled = 10.0;  // how many points the noise of the whole ring counts for beside a station's own
  SurfaceRows& rows = band.rows;
  FootFit fit;
  fit.points = rows.size();
  if (rows.size() < 4) return fit;
  double noise = profile.noise, alike = 1.0;  // so many points whose errors are alike count for one
  double own = profile.noise;
  Eigen::Matrix<double, 6, 1> solution;
  Eigen::Matrix<double, 6, 6> inverse;
  Eigen::Matrix<double, 4, 6> terms;
  for (int iteration = 0; iteration < 8; ++iteration) {
    const SurfaceRows::Equations seen = rows.equations();
    const double used = seen.weight, hidden = std::max(0.0, prior.scatter * prior.scatter - own * own);
    const FeignedSlopes feigned(seen, hidden);
    alike = 1.0 + used * prior.shared / (noise * noise);
    const auto priorWeight = [&](double sigma) { return noise * noise / (sigma * sigma); };
    terms << Eigen::Matrix4d::Identity(), feigned.terms;
    Eigen::Matrix<double, 6, 6> normal = terms.transpose() * seen.matrix * terms;
    Eigen::Matrix<double, 6, 1> right = terms.transpose() * seen.right;
    normal(1, 1) += alike * priorWeight(prior.sigma_slope);
    right[1] += alike * priorWeight(prior.sigma_slope) * prior.slope;
    normal(2, 2) += priorWeight(kSteepestSettlement);
    normal(3, 3) += priorWeight(prior.sigma_bend);
    normal(4, 4) += alike * priorWeight(feigned.across);
    normal(5, 5) += alike * priorWeight(feigned.along);
    if (used < 3.0) return fit;
    inverse = normal.inverse();
    solution = inverse * right;
    own = std::max(rows.residualsFrom(terms * solution), 1e-7);
    fit.row = feigned.row;
    noise = std::sqrt((kPooled * profile.noise * profile.noise + used * own * own) / (kPooled + used));
    rows.weigh(noise);
  }
  fit.z = solution[0];
  fit.slope = solution[1];
  fit.along = solution[2];
  fit.bend = solution[3];
  const double error = noise * std::sqrt(alike);
  const Distances distances(rows);
  fit.sigma = std::hypot(error * std::sqrt(inverse(0, 0)), selectionError(band, distances));
  const Eigen::Matrix<double, 6, 1> lifts = inverse * (terms.transpose() * liftsOf(band, prior.beams));
  fit.lifted = {std::abs(lifts[0]), std::abs(lifts[1])};
  fit.sigma = std::hypot(fit.sigma, fit.lifted.z);
  fit.sigma_slope = std::hypot(error * std::sqrt(inverse(1, 1)), fit.lifted.slope);
  if (prior.rounding.step > 0.0) {
    const double across = distances.spread();
    fit.rounding = prior.rounding.errorOf(own, std::abs(prior.slope) * across);  // the fit's own slopes may be of steps
    fit.sigma = std::hypot(fit.sigma, fit.rounding);
    fit.sigma_slope = std::hypot(fit.sigma_slope, fit.rounding / across);
  }
  fit.noise = noise;
  fit.own = own;
  fit.middle = distances.mean;
  return fit;
}

}  // namespace

FootFit fitFoundation(const std::vector<FootPoint>& points, const FootProfile& profile, double start,
                      const FootPrior& prior) {
  constexpr double kLittle = 0.5;  // of the standard error
  const auto rowsFrom = [&](double from, const BeamEffects& lifted) {
    return rowsOnSurface(points, profile, start, from, lifted);
  };
  BandRows all = rowsFrom(profile.band_from, {});
  if (!prior.beams.reach(profile.band_from)) return fitBand(std::move(all), profile, prior);
  const Told told(all.rows);
  const FootFit fit = fitBand(std::move(all), profile, prior);
  if (!fit.valid() || fit.lifted.z <= kLittle * fit.sigmaOfPoints()) return fit;
  BandRows clear = rowsFrom(prior.beams.to, {});
  const bool is_clear = Told(clear.rows).nearlyAs(told);
  return fitBand(is_clear ? std::move(clear) : rowsFrom(profile.band_from, prior.beams), profile, prior);
}

}  // namespace tank_datum
