#include "foot/polar_ring.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/bucket_sort.h"
#include "core/parallel.h"
#include "core/units.h"

namespace tank_datum {

PolarRing::PolarRing(const Points& points, const Eigen::Vector2d& center) : points_(points.size()) {
  forEachRun(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector2d arm = points[i].head<2>() - center;
      points_[i] = {azimuthOfArm(arm.x(), arm.y()), arm.norm(), points[i].z()};
    }
  });
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

std::pair<std::size_t, std::size_t> PolarRing::inCell(std::size_t cell, std::size_t cells) const {
  const double width = kTwoPi / static_cast<double>(cells);
  const auto begin = [&](std::size_t k) {
    return k == cells ? points_.size() : firstFrom(static_cast<double>(k) * width);
  };
  return {begin(cell), begin(cell + 1)};
}

}  // namespace tank_datum
