#include "foot/foot_patches.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

// Lengths that patches may have, each the next one times the root of the root of two.
constexpr std::size_t kLengths = 14;
constexpr double kLongest = 0.1;                   // [m]
constexpr Eigen::Index kFewest = 10, kMost = 120;  // points of a window

/// The points of a window's band where their rays would meet the fit, and what a fit leaves of their heights.
struct BandResiduals {
  Eigen::MatrixXd places;  ///< d and t of each point [m]
  Eigen::MatrixX4d fit;    ///< what it takes away, orthonormal
  Eigen::VectorXd off;     ///< what it leaves [m]
};

BandResiduals residualsOf(const FittedPoints& fitted, const FootProfile& profile) {
  std::vector<FootPoint> points;
  for (const FootPoint& p : fitted.points) {
    const double off = offOf(p, fitted.fit);
    const FootPoint met = metAt(p, off, fitted);
    if (isOfBand(met, off, fitted.fit, profile)) points.push_back({met.t, met.d, off});
  }
  const auto all = static_cast<Eigen::Index>(points.size()), count = std::min(all, kMost);
  if (count < kFewest) return {};
  BandResiduals left{Eigen::MatrixXd(count, 2), Eigen::MatrixX4d(count, 4), Eigen::VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FootPoint& p = points[static_cast<std::size_t>(i * all / count)];
    left.places.row(i) << p.d, p.t;
    left.fit.row(i) << 1.0, p.d, p.t, p.t * p.t;
    left.off[i] = p.z;
  }
  left.fit = Eigen::MatrixX4d(left.fit.householderQr().householderQ() * Eigen::MatrixX4d::Identity(count, 4));
  left.off -= left.fit * (left.fit.transpose() * left.off);
  return left;
}

/// What each two points have in common of patches of a length and unit variance.
Eigen::MatrixXd alikeOf(const Eigen::MatrixXd& places, double length) {
  Eigen::MatrixXd alike(places.rows(), places.rows());
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      const double apart = (places.row(i) - places.row(j)).squaredNorm();
      alike(i, j) = alike(j, i) = portable::exp(-0.5 * apart / (length * length));
    }
  }
  return alike;
}

/// Products of residuals two by two, and what patches and noise of each point alone would make of them: the fits'
/// covariance is known, so that both variances follow by least squares (Rao's minimum norm quadratic estimation).
class PairProducts {
 public:
  /// @param noise  what points of the window scatter by: noisy windows tell less [m]
  void add(const BandResiduals& left, double noise) {
    const double weight = 1.0 / square(noise * noise);
    squares_ += weight * left.off.squaredNorm();
    free_ += weight * static_cast<double>(left.off.size() - left.fit.cols());
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}}) {
      Eigen::MatrixXd alike = alikeOf(left.places, kLongest * portable::exp2(-0.25 * static_cast<double>(first)));
      for (std::size_t k = first; k < kLengths; k += 2) {
        const Eigen::MatrixXd taken = alike * left.fit, twice = left.fit.transpose() * taken;
        of_[k].products += weight * left.off.dot(alike * left.off);
        of_[k].with_noise += weight * (alike.trace() - twice.trace());
        of_[k].squares += weight * (alike.squaredNorm() - 2.0 * taken.squaredNorm() + twice.squaredNorm());
        alike = alike.array().square().matrix();  // of a length shorter by the root of two
      }
    }
  }

  /// Of all lengths together, each by how likely it is; that there are no patches is as likely before as that there
  /// are.
  Roughness likely() const {
    if (!(free_ > 0.0)) return {};
    std::array<double, kLengths> variances{}, explained{};
    for (std::size_t k = 0; k < kLengths; ++k) {
      const double products = of_[k].products - of_[k].with_noise * squares_ / free_;
      const double expected = of_[k].squares - square(of_[k].with_noise) / free_;
      // by chance products vary by 2 expected: few windows know a variance no better than that of all their points
      if (!(products > 0.0) || !(expected * square(squares_ / free_) > 2.0)) continue;
      variances[k] = products / expected;
      explained[k] = 0.25 * products * products / expected;  // of the logarithm
    }
    const double most = *std::max_element(explained.begin(), explained.end());
    const double none = static_cast<double>(kLengths) * portable::exp(-most);
    double sum = 0, variance = 0, steps = 0;
    for (std::size_t k = 0; k < kLengths; ++k) {
      const double weight = portable::exp(explained[k] - most);
      sum += weight, variance += weight * variances[k], steps += weight * static_cast<double>(k);
    }
    if (!(variance > 0.0)) return {};
    return {std::sqrt(variance / (sum + none)), kLongest * portable::exp2(-0.25 * steps / sum)};
  }

 private:
  struct OfLength {
    double products = 0, with_noise = 0, squares = 0;
  };
  double squares_ = 0, free_ = 0;
  std::array<OfLength, kLengths> of_{};
};

}  // namespace

std::vector<FittedPoints> patchWindows(const Foot& foot, const FootPass& pass) {
  constexpr double kLong = 0.4;  // [m]
  constexpr double kWidest = 5.0 * kPi / 180.0;
  const std::size_t count = pass.fits.size(), stations = foot.stationsIn(std::min(kLong / foot.radius, kWidest));
  std::vector<FittedPoints> windows(count / stations);
  forEachIndex(windows.size(), 0, [&](std::size_t k) {
    const std::size_t at = k * stations + stations / 2;
    if (!pass.fits[at].valid()) return;
    const FootProfile& profile = pass.sections.at(at);
    const double half = static_cast<double>(stations) * foot.half_step, z = pass.fits[at].z;
    std::vector<FootPoint> points = foot.ring.around(foot.directions[at], half, z, foot.reach);
    const FootFit fit = fitFoundation(points, profile, z + profile.offset, pass.priors.at(at));
    windows[k] = {std::move(points), fit, pass.priors.steepnessAt(at)};
  });
  return windows;
}

Roughness patchesOf(const std::vector<FittedPoints>& windows, const FootProfile& profile) {
  PairProducts products;
  for (const FittedPoints& w : windows) {
    if (!w.fit.valid()) continue;
    const BandResiduals left = residualsOf(w, profile);
    if (left.off.size() > 0) products.add(left, std::max(w.fit.noise, profile.noise));
  }
  return products.likely();
}

double LevelRoughness::over(double longer) const {
  return length > 0.0 ? variance * sharedAlong(std::max(longer, arc), length) / sharedAlong(arc, length) : 0.0;
}

double LevelRoughness::slopesBeyond(double seen, const FootProfile& profile, double longer) const {
  if (!(length > 0.0)) return seen;
  const double band = profile.band_to - profile.band_from;
  const double heights = over(longer) / sharedAlong(band, length);  // as if each patch were as long as the band is wide
  return std::sqrt(std::max(0.0, square(seen) - 12.0 * heights / square(band)));
}

double LevelRoughness::leftOutBy(const RingProcess& process, std::size_t place, double own) const {
  if (!(length > 0.0)) return 0.0;
  const double alone = square(process.scale * own) + square(process.nugget);
  const double stations = std::max(1.0, alone / square(process.sigma[place]));
  return std::max(0.0, over(stations * arc) - variance * square(process.scale) / stations);
}

LevelRoughness levelRoughness(const Roughness& patches, const FootProfile& profile, double arc, double least) {
  if (!(patches.heights > 0.0)) return {least, 0.0, arc};
  const double band = profile.band_to - profile.band_from;
  const double level = square(patches.heights) * sharedAlong(band, patches.length) * sharedAlong(arc, patches.length);
  return {std::max(least, level), patches.length, arc};
}

}  // namespace tank_datum
