#pragma once

#include <cstddef>

#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/trust/tank_tests.h"

namespace tank_datum {

constexpr std::size_t kFewestSectors = 8;  ///< that tell of a shell

/// What a tank's shell may be out of round: the standard deviation, of the radius. API 653 lets 13 to 32 mm stand 0.3 m
/// above the foot of tanks of 6 to 40 m of radius; a real one of 10.67 m has 22 mm.
constexpr double kOutOfRoundness = 0.004;

/// What all points of the ring that stand above the foot say of the shell, azimuth by azimuth: no more than spacing,
/// noise and radius go into it.
struct ShellEvidence {
  std::size_t sectors = 0;         ///< in which something stands; the rest is known of kFewestSectors, if a circle fits
  Circle circle;                   ///< through the middle of each [m]
  double spacing = kUnknown;       ///< of the points on the wall [m]
  double noise = kUnknown;         ///< standard deviation of a sector's points about their middle [m]
  double off_round = kUnknown;     ///< robust standard deviation of the middles about the circle [m]
  double on_circle = kUnknown;     ///< share of the middles that noise and out-of-roundness leave there
  double sigma_radius = kUnknown;  ///< standard error of the circle's radius, from the middles [m]
  double cone = kUnknown;          ///< of the wall, positive where it widens upwards [m/m]
  double sigma_cone = kUnknown;    ///< its standard error [m/m]
  ShellLean lean;
  Circle at_foot;  ///< the circle at the foot, from which a shell that leans is away further up [m]

  bool known() const { return circle.valid(); }
  /// How far a wall may be off the circle that noise and out-of-roundness leave on it [m].
  double near() const { return 2.5 * kOutOfRoundness * circle.radius + 2.0 * noise; }
};

ShellEvidence lookAtShell(const Ring& ring, const Tank& tank);

}  // namespace tank_datum
