#include "io/scan_origin.h"

#include <algorithm>
#include <optional>

#include "io/point_extent.h"

namespace tank_datum {
namespace {

/// The first of the points that lies among them and not at zero; nothing when all are there.
std::optional<Eigen::Vector3d> firstAmong(Points points) {
  const auto is_zero = [](const Eigen::Vector3d& p) { return p.isZero(0.0); };
  points.erase(std::remove_if(points.begin(), points.end(), is_zero), points.end());
  if (points.empty()) return std::nullopt;
  const Extent extent = extentOf(points);
  return *std::find_if(points.begin(), points.end(), [&extent](const auto& p) { return extent.holds(p); });
}

}  // namespace

Eigen::Vector3d findOrigin(const std::vector<std::shared_ptr<const Scan::Source>>& sources) {
  std::optional<Eigen::Vector3d> origin;
  for (const auto& source : sources) {
    if (origin) break;
    source->visit(Eigen::Vector3d::Zero(), [&](const Points& block, const Labels&) {
      origin = firstAmong(block);
      return !origin;
    });
  }
  return origin ? Eigen::Vector3d(origin->array() + 0.0)  // + 0.0: no negative zero in the outputs
                : Eigen::Vector3d::Zero();
}

}  // namespace tank_datum
