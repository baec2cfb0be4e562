#include "trust/ground_inside.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/approx_azimuth.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kFewest = 5.0;            // points of a sector that show something
constexpr std::size_t kDegrees = 360;      // sectors
constexpr std::ptrdiff_t kJoined = 5;      // that show a wall of few points
constexpr double kPlenty = 2.0 * kFewest;  // points of the wall in a degree, usually: one without any is no chance

/// What a sector shows: points of the wall, and of the ground on either side of it.
struct SectorSeen {
  double wall = 0, inside = 0, outside = 0;

  void add(const SectorSeen& other) { wall += other.wall, inside += other.inside, outside += other.outside; }
  bool hasWall() const { return wall >= kFewest; }
  /// As ground that goes on from outside: strays lie thinner.
  bool groundGoesOn() const {
    constexpr double kAsDense = 0.3;
    return outside >= kFewest && inside >= std::max(kFewest, kAsDense * outside);
  }
};

/// Degrees of a few joined ones in which the wall is seen, and those in which ground is and no wall.
struct Degrees {
  double wall = 0, open = 0;
};

/// Where the wall is seen by plenty of points, each degree is looked at: posts stand in some of them.
Degrees degreesOf(const SectorSeen* first) {
  constexpr double kNone = 0.1;  // of the fullest degree's points
  SectorSeen all;
  double fullest = 0.0;
  for (const SectorSeen* degree = first; degree != first + kJoined; ++degree) {
    all.add(*degree);
    fullest = std::max(fullest, degree->wall);
  }
  const auto count = static_cast<double>(kJoined);
  if (!all.hasWall()) return {0.0, all.groundGoesOn() ? count : 0.0};
  if (all.wall < kPlenty * count) return {count, 0.0};
  Degrees degrees;
  for (const SectorSeen* degree = first; degree != first + kJoined; ++degree) {
    const bool is_wall = degree->wall >= kNone * fullest;
    degrees.wall += is_wall, degrees.open += !is_wall && degree->groundGoesOn();
  }
  return degrees;
}

}  // namespace

double groundInside(const Ring& ring, const Tank& tank, const ShellEvidence& shell) {
  constexpr std::size_t kEnough = 200'000;  // points
  constexpr double kClear = 0.15;           // of the reach: the wall is above, the ground below
  constexpr double kChance = 3.0;           // standard errors
  if (!shell.known() || tank.side == Side::Inside) return kUnknown;
  const double radius = shell.circle.radius, near = shell.near();
  // opposite to the arc that is seen the circle errs by twice what its radius does
  const double clear = near + 2.0 * kChance * shell.sigma_radius;
  std::vector<SectorSeen> sectors(kDegrees);
  const std::size_t stride = ring.points.size() / kEnough + 1;
  for (std::size_t i = 0; i < ring.points.size(); i += stride) {
    const Eigen::Vector3d& p = ring.points[i];
    const Eigen::Vector2d arm = p.head<2>() - shell.circle.center;
    const double off = arm.norm() - radius, turn = approxTurn(arm.x(), arm.y());
    SectorSeen& sector = sectors[static_cast<std::size_t>(turn * kDegrees) % kDegrees];
    if (p.z() - tank.foot(turn * kTwoPi) >= kClear * ring.reach) {
      sector.wall += std::abs(off) <= near ? 1.0 : 0.0;
    } else if (off < -clear) {
      sector.inside += 1.0;
    } else if (off > clear) {
      sector.outside += 1.0;
    }
  }
  Degrees seen;
  for (auto first = sectors.begin(); first != sectors.end(); first += kJoined) {
    const Degrees degrees = degreesOf(&*first);
    seen.wall += degrees.wall, seen.open += degrees.open;
  }
  return seen.wall > 0.0 ? seen.open / seen.wall : kUnknown;
}

}  // namespace tank_datum
