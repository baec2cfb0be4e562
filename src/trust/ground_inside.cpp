#include "trust/ground_inside.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/approx_azimuth.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kFewest = 5.0;  // points of a sector that show something

/// What a sector shows: points of the wall, and of the ground on either side of it.
struct SectorSeen {
  double wall = 0, inside = 0, outside = 0;

  void add(const SectorSeen& other) { wall += other.wall, inside += other.inside, outside += other.outside; }
  bool hasWall() const { return wall >= kFewest; }
  /// As ground that goes on from outside: strays lie thinner.
  bool isOpen() const {
    constexpr double kAsDense = 0.3;
    return !hasWall() && outside >= kFewest && inside >= std::max(kFewest, kAsDense * outside);
  }
};

/// Open sectors over those with a wall, of so many joined to one.
double shareOpen(const std::vector<SectorSeen>& sectors, std::size_t joined) {
  double walls = 0.0, open = 0.0;
  for (std::size_t first = 0; first < sectors.size(); first += joined) {
    SectorSeen sector;
    for (std::size_t i = first; i < first + joined; ++i) sector.add(sectors[i]);
    walls += sector.hasWall(), open += sector.isOpen();
  }
  return walls > 0.0 ? open / walls : kUnknown;
}

}  // namespace

double groundInside(const Ring& ring, const Tank& tank, const ShellEvidence& shell) {
  constexpr std::size_t kSectors = 360, kJoined = 5;  // a degree tells posts from a wall, five tell it of few points
  constexpr std::size_t kEnough = 200'000;            // points
  constexpr double kClear = 0.15;                     // of the reach: the wall is above, the ground below
  constexpr double kChance = 3.0;                     // standard errors
  if (!shell.known() || tank.side == Side::Inside) return kUnknown;
  const double radius = shell.circle.radius, near = shell.near();
  // opposite to the arc that is seen the circle errs by twice what its radius does
  const double clear = near + 2.0 * kChance * shell.sigma_radius;
  std::vector<SectorSeen> sectors(kSectors);
  const std::size_t stride = ring.points.size() / kEnough + 1;
  for (std::size_t i = 0; i < ring.points.size(); i += stride) {
    const Eigen::Vector3d& p = ring.points[i];
    const Eigen::Vector2d arm = p.head<2>() - shell.circle.center;
    const double off = arm.norm() - radius, turn = approxTurn(arm.x(), arm.y());
    SectorSeen& sector = sectors[static_cast<std::size_t>(turn * kSectors) % kSectors];
    if (p.z() - tank.foot(turn * kTwoPi) >= kClear * ring.reach) {
      sector.wall += std::abs(off) <= near ? 1.0 : 0.0;
    } else if (off < -clear) {
      sector.inside += 1.0;
    } else if (off > clear) {
      sector.outside += 1.0;
    }
  }
  return std::fmax(shareOpen(sectors, kJoined), shareOpen(sectors, 1));  // passes over what is unknown
}

}  // namespace tank_datum
