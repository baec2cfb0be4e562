#pragma once

#include "foot/shell_line.h"
#include "support/made_clouds.h"
#include "support/made_rings.h"

/// Lines of a made shell of half a metre, its foot at z = 0.
namespace tank_datum::made_shell_lines {

inline constexpr double kRadius = 10.0;
inline constexpr double kReach = 0.5;
inline constexpr double kStep = made_clouds::kTurn / 360.0;

/// The line at an azimuth, from heights 0.05 to 0.5 m and a degree on either side.
inline ShellLine lineAt(const Points& points, double azimuth, double from = 0.05, double half_width = kStep) {
  const PolarRing ring(points, {0, 0});
  return fitShellLine(ring, outlineShell(ring, made_rings::levelTank(kRadius), kReach),
                      {azimuth, half_width, 0.0, {from, kReach}});
}

}  // namespace tank_datum::made_shell_lines
