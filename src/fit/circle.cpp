#include "fit/circle.h"

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/statistics.h"

namespace tank_datum {

Circle circleThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  const double scale = u.squaredNorm() + v.squaredNorm();
  if (std::abs(twice_area) <= 1e-12 * scale) return {};
  const Eigen::Vector2d offset((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / (2.0 * twice_area),
                               (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / (2.0 * twice_area));
  return {a + offset, offset.norm()};
}

Circle fitCircle(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights, const Circle& start) {
  if (!start.valid()) return {};
  Circle circle = start;
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d rhs = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d arm = points[i] - circle.center;
      const double distance = arm.norm();
      if (distance == 0.0) continue;
      const double weight = weights.empty() ? 1.0 : weights[i];
      const Eigen::Vector3d row(arm.x() / distance, arm.y() / distance, 1.0);
      normal += weight * row * row.transpose();
      rhs += weight * (distance - circle.radius) * row;
    }
    const Eigen::FullPivLU<Eigen::Matrix3d> lu(normal);
    if (!lu.isInvertible()) return {};
    const Eigen::Vector3d step = lu.solve(rhs);
    circle.center += step.head<2>();
    circle.radius += step.z();
    if (!circle.valid()) return {};
    if (step.norm() < 1e-10 * circle.radius) return circle;
  }
  return {};
}

Circle fitCircleRobust(const std::vector<Eigen::Vector2d>& points, const Circle& start) {
  Circle circle = start;
  std::vector<double> residuals(points.size()), weights(points.size());
  for (int iteration = 0; iteration < 20 && circle.valid(); ++iteration) {
    for (std::size_t i = 0; i < points.size(); ++i) residuals[i] = circle.residual(points[i]);
    const double sigma = std::max(robustSigma(residuals, 0.0), 1e-12 * circle.radius);
    for (std::size_t i = 0; i < points.size(); ++i) weights[i] = tukeyWeight(residuals[i] / sigma);
    const Circle next = fitCircle(points, weights, circle);
    const double moved =
        next.valid() ? (next.center - circle.center).norm() + std::abs(next.radius - circle.radius) : 0;
    circle = next;
    if (moved < 1e-9 * circle.radius) break;
  }
  return circle;
}

Circle findCircle(const std::vector<Eigen::Vector2d>& points, double tolerance) {
  constexpr int kSamples = 2000;  // a third of the points on the circle: missed with probability (1 - 1/27)^2000
  constexpr std::size_t kScored = 5000;
  if (points.size() < 3) return {};
  std::mt19937_64 random(1);
  const auto draw = [&] { return points[random() % points.size()]; };
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kScored);
  Circle best;
  std::size_t best_count = 0;
  for (int sample = 0; sample < kSamples; ++sample) {
    const Circle circle = circleThrough(draw(), draw(), draw());
    if (!circle.valid()) continue;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      if (std::abs(circle.residual(points[i])) <= tolerance) ++count;
    }
    if (count > best_count) {
      best_count = count;
      best = circle;
    }
  }
  if (!best.valid()) return {};
  std::vector<Eigen::Vector2d> near;
  for (const auto& p : points) {
    if (std::abs(best.residual(p)) <= 2.0 * tolerance) near.push_back(p);
  }
  return fitCircleRobust(near, best);
}

}  // namespace tank_datum
