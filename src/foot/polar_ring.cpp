#include "foot/polar_ring.h"

#include <algorithm>
#include <cmath>

#include "core/bucket_sort.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// atan2 of a tiny negative y rounds up to a full turn
double azimuthOf(const Eigen::Vector2d& arm) {
  const double azimuth = std::atan2(arm.y(), arm.x());
  return azimuth >= 0.0 ? azimuth : std::min(azimuth + kTwoPi, std::nextafter(kTwoPi, 0.0));
}

}  // namespace

PolarRing::PolarRing(const Points& points, const Eigen::Vector2d& center) : points_(points.size()) {
  const auto count = static_cast<std::ptrdiff_t>(points.size());
#pragma omp parallel for schedule(static)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector2d arm = points[at].head<2>() - center;
    points_[at] = {azimuthOf(arm), arm.norm(), points[at].z()};
  }
  constexpr std::size_t kSectors = 4096;
  sortByBuckets(
      points_, kSectors, [](const PolarPoint& p) { return static_cast<std::size_t>(p.azimuth / kTwoPi * kSectors); },
      [](const PolarPoint& a, const PolarPoint& b) {
        if (a.azimuth != b.azimuth) return a.azimuth < b.azimuth;
        return a.z != b.z ? a.z < b.z : a.radius < b.radius;
      },
      0);
}

std::size_t PolarRing::firstFrom(double azimuth) const {
  const auto at = std::lower_bound(points_.begin(), points_.end(), azimuth,
                                   [](const PolarPoint& p, double value) { return p.azimuth < value; });
  return static_cast<std::size_t>(at - points_.begin());
}

}  // namespace tank_datum
