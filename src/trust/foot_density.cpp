#include "trust/foot_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/parts.h"
#include "core/plain_text.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "locate/side_sign.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

double footDensity(const Ring& ring, const Tank& tank) {
  constexpr double kClear = 0.04, kLevel = 0.15;  // of the reach: beside the shell, above and below the foot
  constexpr std::size_t kSectors = 72;            // so wide that a foot in sight, however sparse, has a point in each
  using Counts = std::array<double, kSectors>;
  const auto parts = ofParts(ring.points.size(), 0, [&](std::size_t begin, std::size_t end) {
    Counts counts{};
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = ring.points[i];
      const double d = signOf(tank.side) * ((p.head<2>() - tank.circle.center).norm() - tank.circle.radius);
      if (d < kClear * ring.reach || d > ring.reach) continue;
      const double azimuth = tank.azimuthOf(p.head<2>());
      if (std::abs(p.z() - tank.foot(azimuth)) < kLevel * ring.reach) ++counts[ringCell(azimuth, kSectors)];
    }
    return counts;
  });
  Counts all{};
  for (const Counts& counts : parts) {
    for (std::size_t sector = 0; sector < kSectors; ++sector) all[sector] += counts[sector];
  }
  const auto seen = static_cast<double>(kSectors - static_cast<std::size_t>(std::count(all.begin(), all.end(), 0.0)));
  const double points = std::accumulate(all.begin(), all.end(), 0.0);
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
  constexpr double kFewest = 2.0;       // points of a station: with fewer most have none, or one that tells no noise
  constexpr int kStationADegree = 360;  // of those the foot is sparse, and they are not too fine
  if (!(per_degree * 360.0 / stations < kFewest) || stations <= kStationADegree) return {};
  return std::to_string(stations) + " stations are finer than the points of the foot: ask for fewer (option stations)";
}

}  // namespace tank_datum
