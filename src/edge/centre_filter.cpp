#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/azimuth.h"
#include "core/refusal.h"
#include "fit/circle.h"
#include "tank_datum/edge/find_edge_points.h"

namespace tank_datum {
namespace {

double toleranceFor(double radius, const CentreFilterOptions& options) {
  return options.tolerance > 0.0 ? options.tolerance : std::min(0.1, 0.1 * radius);
}

Circle circleOf(const std::vector<Eigen::Vector2d>& plan, const std::optional<Circle>& start,
                const CentreFilterOptions& options) {
  if (!start) {
    Eigen::AlignedBox<double, 2> box;
    for (const auto& p : plan) box.extend(p);
    return findCircle(plan, toleranceFor(0.25 * box.diagonal().norm(), options));
  }
  std::vector<Eigen::Vector2d> near;
  const double tolerance = toleranceFor(start->radius, options);
  for (const auto& p : plan) {
    if (std::abs(start->residual(p)) <= 2.0 * tolerance) near.push_back(p);
  }
  return fitCircleRobust(near, *start);
}

void sortByAzimuth(EdgePoints& edge) {
  std::vector<std::size_t> order(edge.indices.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return edge.azimuths[a] < edge.azimuths[b]; });
  EdgePoints sorted = edge;
  for (std::size_t i = 0; i < order.size(); ++i) {
    sorted.indices[i] = edge.indices[order[i]];
    sorted.azimuths[i] = edge.azimuths[order[i]];
  }
  edge = std::move(sorted);
}

}  // namespace

EdgePoints filterByCentre(const Points& points, const std::vector<std::int32_t>& candidates,
                          const std::optional<Circle>& start, const CentreFilterOptions& options) {
  refuseFirst(firstError(options));
  std::vector<Eigen::Vector2d> plan;
  plan.reserve(candidates.size());
  for (const std::int32_t i : candidates) plan.push_back(points[static_cast<std::size_t>(i)].head<2>());

  EdgePoints edge;
  edge.circle = circleOf(plan, start, options);
  if (!edge.circle.valid()) return edge;
  edge.tolerance = toleranceFor(edge.circle.radius, options);
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (std::abs(edge.circle.residual(plan[i])) > edge.tolerance) continue;
    const Eigen::Vector2d arm = plan[i] - edge.circle.center;
    edge.indices.push_back(candidates[i]);
    edge.azimuths.push_back(azimuthOfArm(arm.x(), arm.y()));
  }
  sortByAzimuth(edge);
  return edge;
}

}  // namespace tank_datum
