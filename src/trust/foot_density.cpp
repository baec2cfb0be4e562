#include "trust/foot_density.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/parts.h"
#include "core/plain_text.h"
#include "core/units.h"

namespace tank_datum {

double footDensity(const Ring& ring, const Tank& tank) {
  constexpr double kClear = 0.04, kLevel = 0.15;  // of the reach: beside the shell, above and below the foot
  const auto isOfFoot = [&](const Eigen::Vector3d& p) {
    const double off = (p.head<2>() - tank.circle.center).norm() - tank.circle.radius;
    const double d = tank.side == Side::Outside ? off : -off;
    if (d < kClear * ring.reach || d > ring.reach) return false;
    return std::abs(p.z() - tank.foot(tank.azimuthOf(p.head<2>()))) < kLevel * ring.reach;
  };
  const auto counts = ofParts(ring.points.size(), 0, [&](std::size_t begin, std::size_t end) {
    const auto first = ring.points.begin();
    return std::count_if(first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end),
                         isOfFoot);
  });
  const auto count = std::accumulate(counts.begin(), counts.end(), std::ptrdiff_t{0});
  return static_cast<double>(count) / toDegrees(tank.coverage);
}

std::string footDensityText(double per_degree) {
  char text[48];
  snprintfPlain(text, sizeof text, "%.*f foundation points a degree", per_degree < 9.95 ? 1 : 0, per_degree);
  return text;
}

std::string sparseFoot(double per_degree) {
  constexpr double kUsual = 20.0;  // with fewer, half of the stations find too few on one surface
  if (!(per_degree < kUsual)) return {};
  char needed[32];
  snprintfPlain(needed, sizeof needed, "; some %.0f are needed", kUsual);
  return footDensityText(per_degree) + needed;
}

}  // namespace tank_datum
