#include "tank_datum/polar_ring.h"

#include <algorithm>
#include <cmath>

#include "units.h"

namespace tank_datum {

namespace {

constexpr std::size_t kSectors = 4096;

/// atan2 of a tiny negative y rounds up to a full turn
double azimuthOf(const Eigen::Vector2d& arm) {
  const double azimuth = std::atan2(arm.y(), arm.x());
  return azimuth >= 0.0 ? azimuth : std::min(azimuth + kTwoPi, std::nextafter(kTwoPi, 0.0));
}

}  // namespace

PolarRing::PolarRing(const Points& points, const Eigen::Vector2d& center) : points_(points.size()) {
  // a counting sort into sectors, then a sort of each: ten million points in a second
  std::vector<PolarPoint> polar(points.size());
  std::vector<std::size_t> starts(kSectors + 1, 0);
  const auto sectorOf = [](double azimuth) { return static_cast<std::size_t>(azimuth / kTwoPi * kSectors); };
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d arm = points[i].head<2>() - center;
    polar[i] = {azimuthOf(arm), arm.norm(), points[i].z()};
  }
  for (const PolarPoint& p : polar) ++starts[sectorOf(p.azimuth) + 1];
  for (std::size_t s = 0; s < kSectors; ++s) starts[s + 1] += starts[s];
  std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
  for (const PolarPoint& p : polar) points_[next[sectorOf(p.azimuth)]++] = p;
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t s = 0; s < kSectors; ++s) {
    const auto at = [&](std::size_t sector) { return points_.begin() + static_cast<std::ptrdiff_t>(starts[sector]); };
    std::sort(at(s), at(s + 1), [](const PolarPoint& a, const PolarPoint& b) {
      if (a.azimuth != b.azimuth) return a.azimuth < b.azimuth;
      return a.z != b.z ? a.z < b.z : a.radius < b.radius;
    });
  }
}

std::size_t PolarRing::firstFrom(double azimuth) const {
  const auto at = std::lower_bound(points_.begin(), points_.end(), azimuth,
                                   [](const PolarPoint& p, double value) { return p.azimuth < value; });
  return static_cast<std::size_t>(at - points_.begin());
}

}  // namespace tank_datum
