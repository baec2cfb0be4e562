#include "foot/raised_foot.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "fit/harmonics.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Where the shell is seen lowest at a station, but for strays [m]; NaN where few of its points are.
double lowestOfShell(const Foot& foot, std::size_t station) {
  constexpr std::size_t kStray = 2, kFewest = 10;  // points
  std::vector<double> heights;
  for (const FootPoint& p : foot.points[station]) {
    if (std::abs(p.d) <= 2.0 * foot.scales.shell_noise) heights.push_back(p.z);
  }
  if (heights.size() < kFewest) return kUnknown;
  std::nth_element(heights.begin(), heights.begin() + kStray, heights.end());
  return heights[kStray];
}

/// A plane through levels, and how they scatter about it [m].
struct Plane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  double scatter = 0.0;

  double at(double direction) const { return harmonicRow(direction, 1).dot(coefficients); }
};

/// The plane of least absolute deviations, which plants before a part of a shell do not turn, by reweighted squares.
/// @param noise  deviations below it weigh alike [m]
Plane planeThrough(const std::vector<double>& directions, const std::vector<double>& levels, double noise) {
  constexpr int kPasses = 50;
  Plane plane;
  plane.coefficients[0] = median(levels);
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const Eigen::Vector3d row = harmonicRow(directions[i], 1);
      const double weight = 1.0 / std::max(noise, std::abs(levels[i] - plane.at(directions[i])));
      normal += weight * row * row.transpose();
      right += weight * levels[i] * row;
    }
    plane.coefficients = normal.ldlt().solve(right);
  }
  std::vector<double> left;
  for (std::size_t i = 0; i < levels.size(); ++i) left.push_back(levels[i] - plane.at(directions[i]));
  plane.scatter = robustSigma(left, median(left));
  return plane;
}

}  // namespace

double raisedAboveRest(const Foot& foot, const std::vector<FootFit>& fits) {
  std::vector<double> directions, levels;
  std::size_t standing = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    standing += fits[i].valid();
    const double level = fits[i].valid() ? kUnknown : lowestOfShell(foot, i);
    if (!std::isfinite(level)) continue;
    directions.push_back(foot.directions[i]);
    levels.push_back(level);
  }
  if (standing == 0 || levels.size() < standing) return kUnknown;
  const Plane plane = planeThrough(directions, levels, foot.scales.shell_noise);
  std::vector<double> above;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (fits[i].valid()) above.push_back(fits[i].z - plane.at(foot.directions[i]));
  }
  return median(std::move(above)) / std::hypot(plane.scatter, foot.scales.shell_noise);
}

}  // namespace tank_datum
