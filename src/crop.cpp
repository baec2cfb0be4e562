#include "tank_datum/crop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tank_datum/voxel_sample.h"
#include "units.h"

namespace tank_datum {

std::string firstError(const CropOptions& options) {
  char text[80] = "";
  if (!(options.reach > 0.0 && std::isfinite(options.reach))) {
    std::snprintf(text, sizeof text, "crop.reach = %g m (must be > 0)", options.reach);
  } else if (options.search_points < 1000) {
    std::snprintf(text, sizeof text, "crop.search_points = %zu (must be >= 1000)", options.search_points);
  }
  return text;
}

Ring cropRing(const Scan& scan, const Tank& tank, const CropOptions& options, const Scan::Visitor& also) {
  Ring ring;
  ring.reach = std::min(options.reach, 0.5 * tank.circle.radius);
  const double reach = ring.reach + 2.0 * tank.resolution;
  const double inner = std::max(0.0, tank.circle.radius - reach), outer = tank.circle.radius + reach;
  const double slope_x = tank.foot.coefficients[1] / tank.circle.radius;
  const double slope_y = tank.foot.coefficients[2] / tank.circle.radius;
  ring.counts = scan.forEachBlock([&](const Points& block) {
    if (also) also(block);
    for (const auto& p : block) {
      const Eigen::Vector2d arm = p.head<2>() - tank.circle.center;
      const double squared = arm.squaredNorm();
      if (squared < inner * inner || squared > outer * outer) continue;
      const double foot = tank.foot.coefficients[0] + slope_x * arm.x() + slope_y * arm.y();
      if (std::abs(p.z() - foot) <= reach) ring.points.push_back(p);
    }
  });
  if (ring.points.size() <= options.search_points) {
    ring.search = ring.points;
    return ring;
  }
  // surfaces fill one layer of voxels: twice the ring's width all round is the area to spread the points over
  const double area = 2.0 * kTwoPi * tank.circle.radius * 2.0 * reach;
  VoxelSample sample(options.search_points, 0.5 * std::sqrt(area / static_cast<double>(options.search_points)));
  sample.add(ring.points);
  ring.search = sample.points();
  return ring;
}

}  // namespace tank_datum
