#include "shell/shell_doubts.h"

#include <cmath>

#include "core/statistics.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

/// The radius farthest off a cell's that the shell is seen to have between it and the middles to the stations beside. A
/// cell of the outline alone may be of strays.
/// @param step  between stations [rad]
double farthestAbout(const ShellOutline& outline, const ShellEdges& edges, double direction, double step,
                     double radius) {
  const std::size_t count = outline.radius.size();
  const double width = kTwoPi / static_cast<double>(count);
  const double on = edges.runsToStep(direction, 1, 0.5 * step);
  double farthest = radius;
  for (double turn = -edges.runsToStep(direction, -1, 0.5 * step); turn <= on; turn += width) {
    const std::size_t cell = ringCell(direction + turn, count);
    const auto at = [&](std::size_t ahead) { return outline.radius[(cell + ahead) % count]; };
    if (std::isnan(at(count - 1) + at(0) + at(1))) continue;
    const double seen = median({at(count - 1), at(0), at(1)});
    if (std::abs(seen - radius) > std::abs(farthest - radius)) farthest = seen;
  }
  return farthest;
}

}  // namespace

void doubtBetween(const ShellOutline& outline, const ShellEdges& edges, const std::vector<Station>& stations,
                  std::vector<ShellCell>& row) {
  const double step = kTwoPi / static_cast<double>(row.size());
  if (step <= kOneDegree) return;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i].seen()) row[i].doubted = farthestAbout(outline, edges, stations[i].direction, step, row[i].radius);
  }
}

}  // namespace tank_datum
