#include "trust/foot_density.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "core/parts.h"
#include "core/plain_text.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

double footDensity(const Ring& ring, const Tank& tank) {
  constexpr double kClear = 0.04, kLevel = 0.15;  // of the reach: beside the shell, above and below the foot
  constexpr double kSectors = 72.0;               // so wide that a foot in sight, however sparse, has a point in each
  using Counts = std::vector<std::size_t>;
  const auto isOfFoot = [&](const Eigen::Vector3d& p) {
    const double off = (p.head<2>() - tank.circle.center).norm() - tank.circle.radius;
    const double d = tank.side == Side::Outside ? off : -off;
    if (d < kClear * ring.reach || d > ring.reach) return false;
    return std::abs(p.z() - tank.foot(tank.azimuthOf(p.head<2>()))) < kLevel * ring.reach;
  };
  const auto parts = ofParts(ring.points.size(), 0, [&](std::size_t begin, std::size_t end) {
    Counts counts(static_cast<std::size_t>(kSectors), 0);
    for (std::size_t i = begin; i < end; ++i) {
      if (!isOfFoot(ring.points[i])) continue;
      const double turns = tank.azimuthOf(ring.points[i].head<2>()) / kTwoPi;
      ++counts[static_cast<std::size_t>(turns * kSectors) % counts.size()];
    }
    return counts;
  });
  double points = 0.0, seen = 0.0;
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(kSectors); ++sector) {
    const double here = std::accumulate(parts.begin(), parts.end(), 0.0, [sector](double sum, const Counts& counts) {
      return sum + static_cast<double>(counts[sector]);
    });
    points += here, seen += here > 0.0 ? 1.0 : 0.0;
  }
  return seen > 0.0 ? points / std::min(seen * 360.0 / kSectors, toDegrees(tank.coverage)) : kUnknown;
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

std::string fineStations(double per_degree, int stations) {
  constexpr double kFewest = 2.0;  // points of a station: with fewer most have none, or one that tells no noise
  if (!(per_degree * 360.0 / stations < kFewest) || stations <= 360) return {};
  return std::to_string(stations) + " stations are finer than the points of the foot: ask for fewer (option stations)";
}

}  // namespace tank_datum
