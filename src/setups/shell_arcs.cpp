#include "setups/shell_arcs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "fit/ring_cells.h"
#include "locate/ring_shape.h"

namespace tank_datum {
namespace {

/// Whether a point so far off the circle, which is not refined, may be one of the shell.
bool isNearShell(double off, double reach) {
  constexpr double kNear = 0.4;  // of the reach
  return std::abs(off) <= kNear * reach;
}

bool isAboveFoot(double above, double reach) { return above > kAboveFoot * reach; }

/// In which arcs more than strays are.
std::vector<bool> seenIn(const ShellArcs& arcs) {
  constexpr double kFewestPoints = 5.0;  // of an arc
  constexpr double kStrays = 0.05;       // of the usual number, at most
  std::vector<double> counts;
  for (const std::size_t points : arcs) {
    if (static_cast<double>(points) >= kFewestPoints) counts.push_back(static_cast<double>(points));
  }
  const double fewest = counts.empty() ? kFewestPoints : std::max(kFewestPoints, kStrays * median(std::move(counts)));
  std::vector<bool> seen;
  for (const std::size_t points : arcs) seen.push_back(static_cast<double>(points) >= fewest);
  return seen;
}

/// Points in a usual one of the arcs that are seen.
double usualOf(const ShellArcs& arcs, const std::vector<bool>& seen) {
  std::vector<double> counts;
  for (std::size_t arc = 0; arc < arcs.size(); ++arc) {
    if (seen[arc]) counts.push_back(static_cast<double>(arcs[arc]));
  }
  return median(std::move(counts));
}

}  // namespace

ShellArcs shellArcs(const Ring& ring, const Tank& tank) {
  ShellArcs arcs(SetupRing::kArcs, 0);
  for (const Eigen::Vector3d& p : ring.points) {
    const Eigen::Vector2d arm = p.head<2>() - tank.circle.center;
    if (!isNearShell(arm.norm() - tank.circle.radius, ring.reach)) continue;
    if (isAboveFoot(p.z() - tank.foot(portable::atan2(arm.y(), arm.x())), ring.reach))
      ++arcs[SetupRing::arcOf(p, tank.circle.center)];
  }
  return arcs;
}

std::vector<ShellArcs> shellArcsOfSetups(const SetupRing& ring, const Tank& tank, double reach, std::size_t setups) {
  constexpr std::size_t kCellsOfArc = SetupRing::kCells / SetupRing::kArcs;
  std::vector<ShellArcs> arcs(setups, ShellArcs(SetupRing::kArcs, 0));
  for (std::size_t cell = 0; cell < SetupRing::kCells; ++cell) {
    const double foot = tank.foot(middleOfCell(cell, SetupRing::kCells));
    for (const SetupRing::Entry* e = ring.begin(cell); e != ring.end(cell); ++e) {
      const bool is_shell = isNearShell(e->radius - tank.circle.radius, reach) && isAboveFoot(e->z - foot, reach);
      arcs[e->setup][cell / kCellsOfArc] += is_shell;
    }
  }
  return arcs;
}

bool isSeenBySeveral(const ShellArcs& arcs, const Tank& tank) {
  const std::vector<bool> seen = seenIn(arcs);
  return tank.side == Side::Outside &&
         SetupRing::spanOf([&](std::size_t arc) { return seen[arc]; }) > SetupRing::kMostOfOneSetup;
}

bool areTiles(const std::vector<ShellArcs>& parts) {
  constexpr std::size_t kBorders = 2;  // arcs that tiles share, for each of them
  constexpr double kFull = 0.5;        // of what parts show elsewhere, they show together where tiles meet
  std::size_t shown = 0;
  std::vector<std::size_t> seen_by(SetupRing::kArcs, 0);
  std::vector<double> fullness(SetupRing::kArcs, 0.0);
  for (const ShellArcs& arcs : parts) {
    const std::vector<bool> seen = seenIn(arcs);
    const double usual = usualOf(arcs, seen);
    shown += std::count(seen.begin(), seen.end(), true) > 0;
    for (std::size_t arc = 0; arc < seen.size(); ++arc) {
      seen_by[arc] += seen[arc];
      if (seen[arc]) fullness[arc] += static_cast<double>(arcs[arc]) / usual;
    }
  }
  std::size_t shared = 0;
  std::vector<double> where_shared;
  for (std::size_t arc = 0; arc < seen_by.size(); ++arc) {
    if (seen_by[arc] < 2) continue;
    shared += seen_by[arc] - 1;
    where_shared.push_back(fullness[arc]);
  }
  return shared > 0 && shared <= kBorders * shown && median(std::move(where_shared)) > kFull;
}

bool areNoSetups(const std::vector<ShellArcs>& setups, const Tank& tank, bool apart) {
  return std::any_of(setups.begin(), setups.end(),
                     [&](const ShellArcs& arcs) { return isSeenBySeveral(arcs, tank); }) ||
         (!apart && areTiles(setups));
}

}  // namespace tank_datum
