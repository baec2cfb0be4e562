#include "locate/circle_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "core/azimuth.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "locate/arc_meter.h"

namespace tank_datum {
namespace {

constexpr double kOutOfRound = 0.01;  // of the radius; API 653 lets 1 % of it stand on large tanks' upper courses
constexpr int kTrials = 20'000;       // a tank holding 5 % of the walls near a trial point is met some 50 times
constexpr double kNearlyWhole = 0.95 * kTwoPi;  // an arc that no other circle's exceeds by much
constexpr int kFewTrials = 2'500;               // enough to better an arc that is no chance already; others come next
constexpr double kNoChance = 0.5 * kTwoPi;
constexpr int kMaxCircles = 40;

using Walls = std::vector<const WallCell*>;

StandingRule ruleFor(double radius, double voxel) { return {voxel + kOutOfRound * radius, kFacing}; }

double binLength(double voxel) { return 4.0 * voxel; }

/// Draws three walls at a random scale, so that small tanks beside large ones are tried as often.
class TripleSampler {
 public:
  TripleSampler(const Walls& walls, double voxel) : walls_(walls), smallest_(12.0 * voxel), random_(1) {
    Eigen::AlignedBox<double, 2> box;
    for (const WallCell* wall : walls) box.extend(wall->position);
    decades_ = portable::log(std::max(2.0, box.diagonal().norm() / smallest_));
  }

  Circle draw(Walls& triple) {
    const WallCell* first = any();
    const double scale = smallest_ * portable::exp(decades_ * uniform());
    const WallCell* second = at(first, scale);
    const WallCell* third = at(first, scale);
    if (!second || !third || second == third) return {};
    triple = {first, second, third};
    return circleThrough(first->position, second->position, third->position);
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }
  const WallCell* any() { return walls_[random_() % walls_.size()]; }
  const WallCell* at(const WallCell* from, double scale) {
    for (int attempt = 0; attempt < 60; ++attempt) {
      const WallCell* wall = any();
      const double distance = (wall->position - from->position).norm();
      if (distance > 0.4 * scale && distance < scale) return wall;
    }
    return nullptr;
  }

  const Walls& walls_;
  double smallest_, decades_ = 0;
  std::mt19937_64 random_;
};

Circle bestTriple(const Walls& walls, double voxel, const LocateOptions& options) {
  TripleSampler sampler(walls, voxel);
  ArcMeter arcs(walls);
  Circle best;
  double best_arc = 0;
  Walls triple;
  const auto is_enough = [&](int trials) {
    return best_arc >= kNearlyWhole || trials >= (best_arc >= kNoChance ? kFewTrials : kTrials);
  };
  for (int trial = 0; !is_enough(trial); ++trial) {
    const Circle circle = sampler.draw(triple);
    if (!circle.valid() || circle.radius < 0.9 * options.min_radius) continue;
    const StandingRule rule = ruleFor(circle.radius, voxel);
    if (!std::all_of(triple.begin(), triple.end(), [&](const auto* w) { return rule.holds(*w, circle); })) continue;
    const double arc = arcs.seen(circle, rule, binLength(voxel));
    if (arc > best_arc) {
      best_arc = arc;
      best = circle;
    }
  }
  return best;
}

/// Fits the circle to the tall ones of its walls: a low wall close by (ringwall, step) must not pull it.
WallCircle refined(const Walls& walls, Circle circle, double voxel) {
  WallCircle result;
  for (int iteration = 0; iteration < 10 && circle.valid(); ++iteration) {
    const StandingRule rule = ruleFor(circle.radius, voxel);
    std::vector<double> heights;
    for (const WallCell* wall : walls) {
      if (rule.holds(*wall, circle)) heights.push_back(wall->top - wall->bottom);
    }
    const double tall = 0.5 * quantile(heights, 0.8);
    std::vector<Eigen::Vector2d> positions;
    for (const WallCell* wall : walls) {
      if (rule.holds(*wall, circle) && wall->top - wall->bottom >= tall) positions.push_back(wall->position);
    }
    circle = fitCircleRobust(positions, circle);
    std::vector<double> residuals;
    for (const auto& p : positions) residuals.push_back(circle.residual(p));
    result.rms = robustSigma(residuals, 0.0);
  }
  result.circle = circle;
  if (circle.valid()) result.coverage = ArcMeter(walls).seen(circle, ruleFor(circle.radius, voxel), binLength(voxel));
  return result;
}

/// On a circle the walls' normals turn with the azimuth, on the sides of a box they do not: the pooled slope, within
/// windows of 20 degrees, of (normal's direction - azimuth) on the azimuth is 0 on the one and -1 on the other.
bool turnsWithAzimuth(const Walls& walls, const Circle& circle, double voxel) {
  constexpr int kWindows = 18;
  struct Sums {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  } sums[kWindows];
  const StandingRule rule = ruleFor(circle.radius, voxel);
  for (const WallCell* wall : walls) {
    if (!rule.holds(*wall, circle)) continue;
    const Eigen::Vector2d radial = (wall->position - circle.center).normalized();
    const double cross = radial.x() * wall->normal.y() - radial.y() * wall->normal.x();
    const double off = portable::atan(cross / radial.dot(wall->normal));
    const double azimuth = azimuthOfArm(radial.x(), radial.y());
    Sums& s = sums[static_cast<int>(azimuth / kTwoPi * kWindows) % kWindows];
    s.n += 1, s.x += azimuth, s.y += off, s.xx += azimuth * azimuth, s.xy += azimuth * off;
  }
  double spread = 0, joint = 0;
  for (const Sums& s : sums) {
    if (s.n < 3) continue;
    spread += s.xx - s.x * s.x / s.n;
    joint += s.xy - s.x * s.y / s.n;
  }
  return joint > -0.5 * spread;
}

}  // namespace

std::vector<WallCircle> findWallCircles(const std::vector<WallCell>& walls, double voxel,
                                        const LocateOptions& options) {
  Walls left;
  for (const WallCell& wall : walls) left.push_back(&wall);
  std::vector<WallCircle> result;
  for (int found = 0; found < kMaxCircles && left.size() >= 8; ++found) {
    const Circle start = bestTriple(left, voxel, options);
    if (!start.valid()) break;
    WallCircle best = refined(left, start, voxel);
    if (!best.circle.valid()) break;
    const bool large = best.circle.radius >= options.min_radius;
    if (best.coverage < options.min_arc) {
      best.rejected = "a tank is known by " + std::to_string(std::lround(toDegrees(options.min_arc))) + " deg at least";
      if (large) result.push_back(best);
      break;
    }
    if (!turnsWithAzimuth(left, best.circle, voxel)) best.rejected = "its walls are flat, like a box's";
    if (large) result.push_back(best);
    StandingRule rule = ruleFor(best.circle.radius, voxel);
    rule.tolerance *= 1.5;
    const auto keep =
        std::remove_if(left.begin(), left.end(), [&](const auto* w) { return rule.holds(*w, best.circle); });
    if (keep == left.end()) break;
    left.erase(keep, left.end());
  }
  return result;
}

}  // namespace tank_datum
