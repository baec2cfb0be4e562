#include "tank_datum/polar_ring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSectors = 4096;

/// atan2 of a tiny negative y rounds up to a full turn
double azimuthOf(const Eigen::Vector2d& arm) {
  const double azimuth = std::atan2(arm.y(), arm.x());
  return azimuth >= 0.0 ? azimuth : std::min(azimuth + kTwoPi, std::nextafter(kTwoPi, 0.0));
}

/// Where the points of every part begin in every sector, when the parts' points follow each other in each.
using Starts = std::vector<std::array<std::size_t, kSectors + 1>>;

}  // namespace

PolarRing::PolarRing(const Points& points, const Eigen::Vector2d& center) : points_(points.size()) {
  // a counting sort into sectors, in parts, then a sort of each sector: ten million points in half a second
  constexpr std::size_t kParts = 16;
  PolarPoints polar(points.size());
  Starts starts(kParts);
  const auto sectorOf = [](double azimuth) { return static_cast<std::size_t>(azimuth / kTwoPi * kSectors); };
  const auto beginOf = [&](std::size_t part) { return points.size() * part / kParts; };
#pragma omp parallel for schedule(dynamic)
  for (std::size_t part = 0; part < kParts; ++part) {
    for (std::size_t i = beginOf(part); i < beginOf(part + 1); ++i) {
      const Eigen::Vector2d arm = points[i].head<2>() - center;
      polar[i] = {azimuthOf(arm), arm.norm(), points[i].z()};
      ++starts[part][sectorOf(polar[i].azimuth)];
    }
  }
  std::size_t next = 0;
  for (std::size_t s = 0; s <= kSectors; ++s) {
    for (auto& of_part : starts) next += std::exchange(of_part[s], next);
  }
  const std::array<std::size_t, kSectors + 1> first = starts.front();
#pragma omp parallel for schedule(dynamic)
  for (std::size_t part = 0; part < kParts; ++part) {
    for (std::size_t i = beginOf(part); i < beginOf(part + 1); ++i) {
      points_[starts[part][sectorOf(polar[i].azimuth)]++] = polar[i];
    }
  }
#pragma omp parallel for schedule(dynamic, 16)
  for (std::size_t s = 0; s < kSectors; ++s) {
    const auto at = [&](std::size_t sector) { return points_.begin() + static_cast<std::ptrdiff_t>(first[sector]); };
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
