#include "foot/shell_fits.h"

#include <algorithm>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "foot/gussets.h"
#include "foot/shell_bends.h"
#include "foot/shell_objects.h"

namespace tank_datum {
double ShellFits::noise() const {
  std::vector<double> noises;
  for (const ShellLine& line : lines) {
    if (line.seen()) noises.push_back(line.noise);
  }
  return median(noises);
}

namespace {

ShellHeights heightsOver(const ShellOutline& outline, double reach) {
  return {std::max(0.1 * reach, 4.0 * outline.noise), reach};
}

/// The directions in which, or a step beside which, something wide stands before the shell.
std::vector<bool> cladDirections(const ShellOutline& outline, const std::vector<double>& directions, const Tank& tank,
                                 double reach) {
  constexpr double kThinnest = 0.06;  // cladding, of the reach: 30 mm; plates are up to 25 mm thick
  const std::size_t cells = outline.radius.size();
  const double arc = kTwoPi * tank.circle.radius / static_cast<double>(cells);
  const std::vector<bool> parts =
      partsBefore({outline.radius, outline.noise, arc}, tank.side == Side::Inside, kThinnest * reach);
  const double step = kTwoPi / static_cast<double>(directions.size());
  std::vector<bool> clad(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (const double beside : {-step, 0.0, step}) {
      if (parts[ringCell(directions[i] + beside, cells)]) clad[i] = true;
    }
  }
  return clad;
}

/// The lines of the shell that is outlined.
ShellFits fitAlong(const ShellOutline& outline, const std::vector<double>& directions, const PolarRing& ring,
                   const Tank& tank, double reach) {
  constexpr std::size_t kPlenty = 40;                 // points for four unknowns
  constexpr double kWidestShell = 5.0 * kPi / 180.0;  // half the arc that a sparse station may borrow points from
  constexpr double kWider = 1.5;
  ShellFits shell;
  shell.heights = heightsOver(outline, reach);
  shell.clad = cladDirections(outline, directions, tank, reach);
  shell.lines.resize(directions.size());
  const double step = kTwoPi / static_cast<double>(directions.size());
  auto& lines = shell.lines;
  std::vector<ShellWindow> windows(directions.size());
  forEachIndex(directions.size(), 0, [&](std::size_t i) {
    const double azimuth = directions[i];
    ShellWindow& window = windows[i];
    window = {azimuth, step, tank.foot(azimuth), shell.heights};
    lines[i] = fitShellLine(ring, outline, window);
    while (lines[i].points < kPlenty && kWider * window.half_width < kWidestShell) {
      window.half_width *= kWider;
      lines[i] = fitShellLine(ring, outline, window);
    }
    if (!lines[i].isSupportedWithin(step * tank.circle.radius)) lines[i] = {};
  });
  lines = linesAtFoot(ring, lines, windows);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (shell.clad[i]) lines[i] = {};
  }
  return shell;
}

}  // namespace

ShellFits fitShellLines(const std::vector<double>& directions, const PolarRing& ring, const Tank& tank, double reach) {
  const ShellOutline outline = outlineShell(ring, tank, reach);
  const auto others = withoutGussets(ring, outline, tank, heightsOver(outline, reach));
  if (!others) return fitAlong(outline, directions, ring, tank, reach);
  return fitAlong(outlineShell(*others, tank, reach), directions, *others, tank, reach);
}

}  // namespace tank_datum
