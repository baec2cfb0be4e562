#include "trust/shell_evidence.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parts.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestOfSector = 5;  // points of a sector that have a middle

/// A point of the wall: its azimuth, its height above the foot, and its distance from the axis.
struct WallPoint {
  double azimuth, height, radius;
};

using Wall = std::vector<WallPoint>;

/// What stands within a tenth of the radius of the shell, clear of the foot.
Wall wallOf(const Ring& ring, const Tank& tank) {
  constexpr double kBeside = 0.1, kClear = 0.15;  // of the radius; of the ring's reach
  const double band = std::min(kBeside * tank.circle.radius, ring.reach);
  return concatenated(ofParts(ring.points.size(), 0, [&](std::size_t begin, std::size_t end) {
    Wall part;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = ring.points[i];
      const double radius = (p.head<2>() - tank.circle.center).norm();
      if (std::abs(radius - tank.circle.radius) > band) continue;
      const double azimuth = tank.azimuthOf(p.head<2>()), height = p.z() - tank.foot(azimuth);
      if (height >= kClear * ring.reach && height <= ring.reach) part.push_back({azimuth, height, radius});
    }
    return part;
  }));
}

/// Leaves of a sector what stands above a heap against the shell: nothing is seen at the shell's radius below its top.
void leaveAboveHeap(Wall& sector, const Tank& tank, double reach) {
  constexpr double kAtShell = 0.01, kHidden = 0.3;  // of the radius; of the reach: more of the shell is hidden
  constexpr double kStrays = 0.05;                  // of the points
  std::vector<double> heights;
  for (const WallPoint& p : sector) {
    if (std::abs(p.radius - tank.circle.radius) <= kAtShell * tank.circle.radius) heights.push_back(p.height);
  }
  const double top = quantile(heights, kStrays);
  if (!(top > kHidden * reach)) return;
  sector.erase(std::remove_if(sector.begin(), sector.end(), [top](const WallPoint& p) { return p.height < top; }),
               sector.end());
}

std::vector<Wall> inSectors(const Wall& wall, std::size_t count) {
  std::vector<Wall> sectors(count);
  for (const WallPoint& p : wall) sectors[ringCell(p.azimuth, count)].push_back(p);
  return sectors;
}

/// The middle of a sector's wall: what stands apart from the median is no part of it.
struct Middle {
  double azimuth, radius, noise;
  double height = 0.0;     ///< above the foot [m]
  double lean = kUnknown;  ///< outwards [m/m]
};

double medianHeight(const Wall& points) {
  std::vector<double> heights;
  for (const WallPoint& p : points) heights.push_back(p.height);
  return median(heights);
}

double leanOf(const Wall& points, double least_height) {
  double n = 0, h = 0, r = 0, hh = 0, hr = 0;
  double low = points.front().height, high = low;
  for (const WallPoint& p : points) {
    n += 1, h += p.height, r += p.radius, hh += p.height * p.height, hr += p.height * p.radius;
    low = std::min(low, p.height), high = std::max(high, p.height);
  }
  const double spread = hh - h * h / n;
  return n >= 8 && high - low >= least_height && spread > 0.0 ? (hr - h * r / n) / spread : kUnknown;
}

Middle middleOf(Wall points, double azimuth, double least_height) {
  constexpr double kApart = 5.0;  // sigmas
  const auto radii = [&points] {
    std::vector<double> values;
    for (const WallPoint& p : points) values.push_back(p.radius);
    return values;
  };
  const double first = median(radii()), spread = kApart * robustSigma(radii(), first);
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const WallPoint& p) { return std::abs(p.radius - first) > spread + 1e-9 * first; }),
               points.end());
  Middle middle;
  middle.azimuth = azimuth;
  middle.radius = median(radii());
  middle.noise = robustSigma(radii(), middle.radius);
  middle.height = medianHeight(points);
  middle.lean = leanOf(points, least_height);
  return middle;
}

/// Spacing of the points on the wall, from the sectors of a first, coarse look.
double spacingOf(const std::vector<Wall>& sectors, double width) {
  std::vector<double> spacings;
  for (const auto& points : sectors) {
    if (points.size() < kFewestOfSector) continue;
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [](const auto& a, const auto& b) { return a.height < b.height; });
    spacings.push_back(std::sqrt(width * (high->height - low->height) / static_cast<double>(points.size())));
  }
  return median(spacings);
}

/// The middles of sectors three spacings wide.
std::vector<Middle> middlesOf(const Ring& ring, const Tank& tank, double& spacing) {
  constexpr std::size_t kCoarse = 48, kFinest = 360;
  const double round = kTwoPi * tank.circle.radius;
  const Wall wall = wallOf(ring, tank);
  spacing = spacingOf(inSectors(wall, kCoarse), round / double(kCoarse));
  if (!(spacing > 0.0)) return {};
  const auto count = static_cast<std::size_t>(std::clamp(round / (3.0 * spacing), 24.0, double(kFinest)));
  std::vector<Wall> sectors = inSectors(wall, count);
  const double width = kTwoPi / static_cast<double>(count);
  return concatenated(ofParts(count, 0, [&](std::size_t begin, std::size_t end) {
    std::vector<Middle> middles;
    for (std::size_t i = begin; i < end; ++i) {
      leaveAboveHeap(sectors[i], tank, ring.reach);
      if (sectors[i].size() < kFewestOfSector) continue;
      middles.push_back(middleOf(sectors[i], (static_cast<double>(i) + 0.5) * width, 0.3 * ring.reach));
    }
    return middles;
  }));
}

double medianOf(const std::vector<Middle>& middles, double Middle::*value) {
  std::vector<double> values;
  for (const Middle& m : middles) {
    if (std::isfinite(m.*value)) values.push_back(m.*value);
  }
  return median(values);
}

/// What all sectors share of their leans, and its standard error: on a short arc no fit tells a cone from a lean.
void lookForCone(const std::vector<Middle>& middles, ShellEvidence& evidence) {
  std::vector<double> leans;
  for (const Middle& m : middles) {
    if (std::isfinite(m.lean)) leans.push_back(m.lean);
  }
  if (leans.size() < 8) return;
  evidence.cone = median(leans);
  evidence.sigma_cone =
      kMedianOverMean * robustSigma(leans, evidence.cone) / std::sqrt(static_cast<double>(leans.size()));
}

/// The lean of each sector is a cone's and what the axis' lean makes of it: cone + slope . direction.
void fitLean(const std::vector<Middle>& middles, ShellEvidence& evidence) {
  Eigen::Vector3d fit(medianOf(middles, &Middle::lean), 0.0, 0.0);
  double sigma = kUnknown;
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  for (int iteration = 0; iteration < 10; ++iteration) {
    std::vector<double> off;
    for (const Middle& m : middles) {
      if (std::isfinite(m.lean))
        off.push_back(m.lean - fit.dot(Eigen::Vector3d(1, portable::cos(m.azimuth), portable::sin(m.azimuth))));
    }
    if (off.size() < 8) return;
    sigma = std::max(robustSigma(off, 0.0), 1e-9);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Middle& m : middles) {
      if (!std::isfinite(m.lean)) continue;
      const Eigen::Vector3d row(1, portable::cos(m.azimuth), portable::sin(m.azimuth));
      const double weight = tukeyWeight((m.lean - fit.dot(row)) / sigma);
      normal += weight * row * row.transpose();
      right += weight * m.lean * row;
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
    if (!lu.isInvertible()) return;
    inverse = lu.inverse();
    fit = inverse * right;
  }
  evidence.lean.slope = fit.tail<2>();
  evidence.lean.sigma = sigma * std::sqrt(std::max(inverse(1, 1), inverse(2, 2)));
}

double sigmaOfRadius(const std::vector<Middle>& middles, const Circle& circle, double sigma) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (const Middle& m : middles) {
    const Eigen::Vector3d row(portable::cos(m.azimuth), portable::sin(m.azimuth), 1.0);
    normal += row * row.transpose();
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
  return lu.isInvertible() ? sigma * std::sqrt(lu.inverse()(2, 2)) : circle.radius;
}

}  // namespace

ShellEvidence lookAtShell(const Ring& ring, const Tank& tank) {
  ShellEvidence evidence;
  const std::vector<Middle> middles = middlesOf(ring, tank, evidence.spacing);
  evidence.sectors = middles.size();
  if (middles.size() < kFewestSectors) return evidence;
  std::vector<Eigen::Vector2d> plan;
  for (const Middle& m : middles) {
    plan.push_back(tank.circle.center + m.radius * Eigen::Vector2d(portable::cos(m.azimuth), portable::sin(m.azimuth)));
  }
  evidence.circle = fitCircleRobust(plan, tank.circle);
  if (!evidence.circle.valid()) return evidence;
  evidence.noise = medianOf(middles, &Middle::noise);
  std::vector<double> off;
  for (const auto& p : plan) off.push_back(evidence.circle.residual(p));
  evidence.off_round = robustSigma(off, 0.0);
  const double near = evidence.near();
  evidence.on_circle =
      static_cast<double>(std::count_if(off.begin(), off.end(), [near](double r) { return std::abs(r) <= near; })) /
      static_cast<double>(off.size());
  evidence.sigma_radius = sigmaOfRadius(middles, evidence.circle, evidence.off_round);
  lookForCone(middles, evidence);
  fitLean(middles, evidence);
  evidence.at_foot = evidence.circle;
  if (evidence.lean.known()) evidence.at_foot.center -= medianOf(middles, &Middle::height) * evidence.lean.slope;
  return evidence;
}

}  // namespace tank_datum
