#include "foot/shell_fits.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
double ShellFits::noise() const {
  std::vector<double> noises;
  for (const ShellLine& line : lines) {
    if (line.seen()) noises.push_back(line.noise);
  }
  return median(noises);
}

ShellFits fitShellLines(const std::vector<double>& directions, const PolarRing& ring, const Tank& tank, double reach) {
  constexpr std::size_t kPlenty = 40;                 // points for four unknowns
  constexpr double kWidestShell = 5.0 * kPi / 180.0;  // half the arc that a sparse station may borrow points from
  const ShellOutline outline = outlineShell(ring, tank, reach);
  ShellFits shell;
  shell.heights = {std::max(0.1 * reach, 4.0 * outline.noise), reach};
  shell.lines.resize(directions.size());
  const double step = kTwoPi / static_cast<double>(directions.size());
  auto& lines = shell.lines;
  forEachIndex(directions.size(), 0, [&](std::size_t i) {
    const double azimuth = directions[i];
    for (double half = step; lines[i].points < kPlenty && half < kWidestShell; half *= 1.5) {
      lines[i] = fitShellLine(ring, outline, {azimuth, half, tank.foot(azimuth), shell.heights});
    }
    if (!lines[i].isSupportedWithin(step * tank.circle.radius)) lines[i] = {};
  });
  return shell;
}

}  // namespace tank_datum
