#include "setups/shell_arcs.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "setups/setup_ring.h"

namespace tank_datum {
namespace {

constexpr double kFewestPoints = 5.0;  // of an arc

/// How many points of an arc are no strays.
double fewestOf(const std::vector<std::size_t>& arcs) {
  constexpr double kStrays = 0.05;  // of the usual number, at most
  std::vector<double> seen;
  for (const std::size_t points : arcs) {
    if (static_cast<double>(points) >= kFewestPoints) seen.push_back(static_cast<double>(points));
  }
  return seen.empty() ? kFewestPoints : std::max(kFewestPoints, kStrays * median(std::move(seen)));
}

}  // namespace

std::vector<std::vector<std::size_t>> shellArcs(const Ring& ring, const Tank& tank) {
  constexpr double kFrom = 0.3, kNear = 0.4;  // of the reach: above the foot, and off the circle, which is not refined
  std::vector<std::vector<std::size_t>> arcs(ring.setupCount(), std::vector<std::size_t>(SetupRing::kArcs, 0));
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Eigen::Vector3d& p = ring.points[i];
    const Eigen::Vector2d arm = p.head<2>() - tank.circle.center;
    if (std::abs(arm.norm() - tank.circle.radius) > kNear * ring.reach) continue;
    if (p.z() > tank.foot(portable::atan2(arm.y(), arm.x())) + kFrom * ring.reach)
      ++arcs[ring.setupOf(i)][SetupRing::arcOf(p, tank.circle.center)];
  }
  return arcs;
}

bool isSeenBySeveral(const std::vector<std::size_t>& arcs, const Tank& tank) {
  if (tank.side != Side::Outside) return false;
  const double fewest = fewestOf(arcs);
  return SetupRing::spanOf([&](std::size_t arc) { return static_cast<double>(arcs[arc]) >= fewest; }) >
         SetupRing::kMostOfOneSetup;
}

bool areNoSetups(const std::vector<std::vector<std::size_t>>& arcs, const Tank& tank) {
  constexpr std::size_t kBorders = 2;  // arcs that tiles share, for each of them
  std::size_t parts = 0;
  std::vector<std::size_t> seen(SetupRing::kArcs, 0);
  for (const std::vector<std::size_t>& of_part : arcs) {
    if (isSeenBySeveral(of_part, tank)) return true;
    const double fewest = fewestOf(of_part);
    bool shows = false;
    for (std::size_t arc = 0; arc < of_part.size(); ++arc) {
      const bool sees = static_cast<double>(of_part[arc]) >= fewest;
      seen[arc] += sees, shows = shows || sees;
    }
    parts += shows;
  }
  std::size_t shared = 0;
  for (const std::size_t by : seen) shared += std::max<std::size_t>(1, by) - 1;
  return shared > 0 && shared <= kBorders * parts;
}

}  // namespace tank_datum
