#include "foot/liquid_level.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "foot/foot_check.h"
#include "foot/foot_heaps.h"

namespace tank_datum {
namespace {

constexpr double kOffLevel = 5e-5;             // standard deviation of what a scan is off level by: 10" [m/m]
constexpr double kLiquidArc = 40.0 * kDegree;  // over which no floor follows a level by itself
constexpr double kOffTheLevel = 4.0;           // standard errors
constexpr double kMostVariance = 2.0;          // of what lies on a level, over that of the standard errors

using Indices = std::vector<std::size_t>;

/// What a station's elevation and its own points say.
struct SeenStation {
  double direction, z, sigma;  ///< [rad], [m]
  double slope, sigma_slope;   ///< [m/m]

  /// Its slope's square over the variance of one that is none.
  double sloping() const { return square(slope) / (square(sigma_slope) + square(kOffLevel)); }
};

/// Whether the mean slope of stations is none; their points count for the neighbours too.
bool isWithoutSlope(const std::vector<SeenStation>& all, const Indices& some) {
  double weights = 0.0, sum = 0.0;
  for (const std::size_t i : some) {
    const double weight = 1.0 / square(all[i].sigma_slope);
    weights += weight, sum += weight * all[i].slope;
  }
  return std::abs(sum / weights) <= kOffTheLevel * std::hypot(std::sqrt(kWithNeighbours / weights), kOffLevel);
}

/// A plane that is level as far as scans are.
struct LevelPlane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();

  double above(const SeenStation& s) const { return s.z - harmonicRow(s.direction, 1).dot(coefficients); }
};

LevelPlane levelPlaneThrough(const std::vector<SeenStation>& all, const Indices& some, double radius) {
  const double off = square(kOffLevel * radius);
  Eigen::Matrix3d normal = Eigen::Vector3d(0.0, 1.0 / off, 1.0 / off).asDiagonal();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double base = all[some.front()].z;
  for (const std::size_t i : some) {
    const Eigen::Vector3d row = harmonicRow(all[i].direction, 1);
    const double weight = 1.0 / square(all[i].sigma);
    normal += weight * row * row.transpose();
    right += weight * (all[i].z - base) * row;
  }
  LevelPlane plane{normal.ldlt().solve(right)};
  plane.coefficients[0] += base;
  return plane;
}

/// Whether stations lie on one level, without slope on the whole, as far as their standard errors tell.
bool areLevel(const std::vector<SeenStation>& all, const Indices& some, double radius) {
  const LevelPlane plane = levelPlaneThrough(all, some, radius);
  double sum = 0.0;
  for (const std::size_t i : some) sum += square(plane.above(all[i]) / all[i].sigma);
  return sum <= kMostVariance * static_cast<double>(some.size()) && isWithoutSlope(all, some);
}

/// Whether most stations lie on a plane as far as their standard errors tell: arcs that are level each by itself may be
/// parts of a floor that is not.
bool areMostOn(const LevelPlane& plane, const std::vector<SeenStation>& all, const Indices& some) {
  std::vector<double> above;
  for (const std::size_t i : some) above.push_back(plane.above(all[i]) / all[i].sigma);
  return square(robustSigma(above, 0.0)) <= kMostVariance;
}

/// Usual standard error of stations' elevations [m].
double usualSigma(const std::vector<SeenStation>& all, const Indices& some) {
  std::vector<double> sigmas;
  for (const std::size_t i : some) sigmas.push_back(all[i].sigma);
  return median(std::move(sigmas));
}

/// Whether elevations are known so well that no floor would pass for level all round.
bool wouldTell(const std::vector<SeenStation>& all, const Indices& some) {
  constexpr double kKnown = 0.0003;  // [m]
  return usualSigma(all, some) <= kKnown;
}

/// Usual square of a slope over its variance, of stations.
double usualSlope(const std::vector<SeenStation>& all, const Indices& some) {
  std::vector<double> sloping;
  for (const std::size_t i : some) sloping.push_back(all[i].sloping());
  return median(std::move(sloping));
}

/// Whether the floor climbs beside the level by so much that a tilted one would leave it within the level's arc.
/// @param plane  through the level
bool climbs(const std::vector<SeenStation>& all, const Indices& on, const Indices& off, const LevelPlane& plane,
            double radius) {
  constexpr double kTimes = 5.0;  // standard errors that it would do so by
  const double half = 0.5 * kTwoPi * static_cast<double>(on.size()) / static_cast<double>(all.size());
  std::vector<double> rises;
  for (const std::size_t i : off) rises.push_back(plane.above(all[i]));
  const double error = std::hypot(usualSigma(all, on), kOffLevel * radius);
  return 0.5 * median(std::move(rises)) * (1.0 - portable::cos(half)) > kTimes * error;
}

std::vector<SeenStation> seenOf(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<FootFit>& own) {
  const double common = commonSigma(fits, 1);
  std::vector<SeenStation> all;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const bool is_known = fits[i].valid() && own[i].valid();
    all.push_back({foot.directions[i], is_known ? fits[i].z : kUnknown, std::hypot(fits[i].sigma, common), own[i].slope,
                   own[i].sigma_slope});
  }
  return all;
}

/// Arcs that lie level, each by itself.
std::vector<Indices> levelArcs(const std::vector<SeenStation>& all, std::size_t arc, double radius) {
  constexpr double kMost = 0.8;  // of the arc is seen
  std::vector<Indices> level;
  for (std::size_t from = 0; from < all.size(); ++from) {
    Indices some;
    for (std::size_t k = from; k < from + arc; ++k) {
      if (std::isfinite(all[k % all.size()].z)) some.push_back(k % all.size());
    }
    if (static_cast<double>(some.size()) >= kMost * static_cast<double>(arc) && areLevel(all, some, radius))
      level.push_back(std::move(some));
  }
  return level;
}

/// Stations of level arcs on the surface of the lowest of them.
std::vector<bool> onLowest(const std::vector<SeenStation>& all, const std::vector<Indices>& arcs, double radius) {
  std::vector<bool> on(all.size(), false);
  if (arcs.empty()) return on;
  const auto middle = [&](const Indices& arc) { return all[arc[arc.size() / 2]].z; };
  const auto lowest = std::min_element(arcs.begin(), arcs.end(),
                                       [&](const Indices& a, const Indices& b) { return middle(a) < middle(b); });
  const LevelPlane plane = levelPlaneThrough(all, *lowest, radius);
  for (const Indices& arc : arcs) {
    for (const std::size_t i : arc) {
      const double sigma = std::hypot(all[i].sigma, kOffLevel * radius);
      if (std::abs(plane.above(all[i])) <= kOffTheLevel * sigma) on[i] = true;
    }
  }
  return on;
}

/// Those beside the liquid too, on either shore, which show it and the floor: their windows hold stations of both, or
/// they lie below it, as a line through the liquid at the shell and the floor beyond does.
std::vector<bool> withShores(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<bool>& on,
                             const std::vector<bool>& below) {
  constexpr double kShore = 5.0 * kDegree;
  const std::size_t count = on.size(), far = foot.stationsBeside(kShore);
  std::vector<bool> hidden = on;
  for (std::size_t i = 0; i < count; ++i) {
    if (!on[i]) continue;
    for (const std::size_t step : {std::size_t{1}, count - 1}) {
      std::size_t k = (i + step) % count;
      for (std::size_t n = 1; n <= far && !on[k]; ++n, k = (k + step) % count) {
        const std::size_t near = fits[k].valid() ? foot.stationsBeside(fits[k].half_width + foot.half_step) : n;
        if (n <= near || below[k]) hidden[k] = true;
      }
    }
  }
  return hidden;
}

}  // namespace

LiquidLevel findLiquidLevel(const Foot& foot, const std::vector<FootFit>& fits, const std::vector<FootFit>& own) {
  constexpr double kSlopes = 10.0;  // times those on the level: of the floor, so that no part of it is level by chance
  constexpr double kFewBelow = 0.02;  // of the others, by chance
  const std::vector<SeenStation> all = seenOf(foot, fits, own);
  const std::size_t arc = foot.stationsIn(kLiquidArc);
  const std::vector<bool> level = onLowest(all, levelArcs(all, arc, foot.radius), foot.radius);
  Indices on, off;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (level[i]) on.push_back(i);
  }
  if (on.empty()) return {};
  const LevelPlane plane = levelPlaneThrough(all, on, foot.radius);
  if (!areMostOn(plane, all, on)) return {};
  std::vector<bool> below;
  for (const SeenStation& s : all) below.push_back(plane.above(s) < -kOffTheLevel * s.sigma);
  std::vector<bool> hidden = withShores(foot, fits, level, below);
  double lower = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (hidden[i] || !std::isfinite(all[i].z)) continue;
    off.push_back(i);
    lower += below[i];
  }
  if (off.empty()) return {std::move(hidden), wouldTell(all, on) ? 1.0 : 0.0};
  const bool is_lowest = lower <= kFewBelow * static_cast<double>(off.size());
  const bool slopes = usualSlope(all, off) >= square(kSlopes) * std::max(1.0, usualSlope(all, on));
  if (off.size() < arc || !is_lowest || !(slopes || climbs(all, on, off, plane, foot.radius))) return {};
  for (std::size_t i = 0; i < all.size(); ++i) {  // and single ones, too few to tell it by
    if (std::abs(plane.above(all[i])) <= kOffTheLevel * all[i].sigma) hidden[i] = true;
  }
  const double share = static_cast<double>(on.size()) / static_cast<double>(on.size() + off.size());
  return {std::move(hidden), share};
}

FootPass withoutLiquid(const Foot& foot, FootPass pass) {
  if (!foot.inside) return pass;
  const LiquidLevel liquid = findLiquidLevel(foot, pass.fits, standing(pass.outliers.own, pass.outliers.reasons));
  pass.liquid = liquid.share;
  if (!pass.hasLiquid()) return pass;
  for (std::size_t i = 0; i < liquid.stations.size(); ++i) {
    if (liquid.stations[i] && pass.fits[i].valid()) pass.outliers.reasons[i] = Unmeasured::OtherSurface;
  }
  pass.fits = standing(std::move(pass.fits), pass.outliers.reasons);
  return pass;
}

}  // namespace tank_datum
