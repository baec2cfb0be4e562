#include "setups/setup_ring.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/parallel.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "locate/ring_shape.h"

namespace tank_datum {
namespace {

double turnOf(const Eigen::Vector2d& arm) { return azimuthOfArm(arm.x(), arm.y()); }

std::size_t cellOf(double azimuth) {
  return std::min(SetupRing::kCells - 1, static_cast<std::size_t>(azimuth / kTwoPi * SetupRing::kCells));
}

}  // namespace

std::size_t SetupRing::arcOf(const Eigen::Vector3d& point, const Eigen::Vector2d& center) {
  return cellOf(turnOf(point.head<2>() - center)) / (kCells / kArcs);
}

SetupRing::SetupRing(const Ring& ring, const Tank& tank, int threads) {
  sortIntoCells(ring, tank.circle.center, threads);
  findOutline(tank, ring.reach, threads);
}

void SetupRing::sortIntoCells(const Ring& ring, const Eigen::Vector2d& center, int threads) {
  const std::size_t count = ring.points.size();
  std::vector<float> turns(count);  // fine enough for a cell
  forEachRun(count, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) turns[i] = static_cast<float>(turnOf(ring.points[i].head<2>() - center));
  });
  starts_.assign(kCells + 1, 0);
  for (const float turn : turns) ++starts_[cellOf(static_cast<double>(turn)) + 1];
  for (std::size_t cell = 0; cell < kCells; ++cell) starts_[cell + 1] += starts_[cell];
  std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
  std::vector<std::uint32_t> order(count);
  for (std::size_t i = 0; i < count; ++i) {
    order[next[cellOf(static_cast<double>(turns[i]))]++] = static_cast<std::uint32_t>(i);
  }
  entries_.resize(count);
  forEachIndex(kCells, threads, [&](std::size_t cell) {
    for (std::size_t at = starts_[cell]; at < starts_[cell + 1]; ++at) {
      const std::size_t i = order[at];
      const Eigen::Vector2d arm = ring.points[i].head<2>() - center;
      entries_[at] = {turnOf(arm), arm.norm(), ring.points[i].z(), ring.setupOf(i)};
    }
  });
}

void SetupRing::findOutline(const Tank& tank, double reach, int threads) {
  outline_.resize(kCells);
  forEachIndex(kCells, threads, [&](std::size_t cell) {
    std::vector<double> radii;
    for (const Entry* e = begin(cell); e != end(cell); ++e) {
      if (e->z > tank.foot(e->azimuth) + kAboveFoot * reach) radii.push_back(e->radius);
    }
    outline_[cell] = densestOfCell(radii);
  });
}

double SetupRing::outlineAt(double azimuth) const { return betweenCells(outline_, azimuth); }

}  // namespace tank_datum
