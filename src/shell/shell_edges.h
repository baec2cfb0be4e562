#pragma once

#include <vector>

#include "foot/polar_ring.h"
#include "foot/shell_line.h"
#include "shell/sharp_steps.h"

namespace tank_datum {

/// The edges of a row of the shell: where something before it begins or ends, or a plate upon it.
class ShellEdges {
 public:
  /// @param outline  of the row; kept by reference
  /// @param radius   of the shell, roughly [m]
  ShellEdges(const PolarRing& ring, const ShellOutline& outline, double radius);

  /// How far the shell runs on from a direction without an edge, one way, at most so far [rad].
  /// @param way  1 counter-clockwise, -1 clockwise
  double runsOn(double direction, int way, double widest) const;

  /// How far it does without a sharp step: over the flanks of a dent, however steep.
  double runsToStep(double direction, int way, double widest) const;

  /// By how much the shell steps from one azimuth [rad] on to another [m].
  double stepsBetween(double from, double to) const;

 private:
  double runsOnInOutline(double direction, int way, double widest) const;

  const ShellOutline& outline_;
  std::vector<char> edge_;  ///< after a cell, before the next that shows something
  std::vector<SharpStep> steps_;
  double blur_;  ///< of where they are [rad]
};

}  // namespace tank_datum
