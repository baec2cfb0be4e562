#include "shell/shell_edges.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "foot/shell_objects.h"

namespace tank_datum {
namespace {

constexpr double kBlur = 0.0125;  // of where a step is: half a column of points [m]

/// After which cells of an outline there is an edge: a jump that three cells on either side confirm; one alone may be
/// of strays.
std::vector<char> edgesOf(const ShellOutline& outline, double radius) {
  std::vector<char> edge(outline.radius.size());
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    if (std::isfinite(outline.radius[i])) seen.push_back(i);
  }
  const std::size_t count = seen.size();
  const auto at = [&](std::size_t k) { return outline.radius[seen[k % count]]; };
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t cells = (seen[(k + 1) % count] + edge.size() - seen[k]) % edge.size();
    const double arc = kTwoPi * radius * static_cast<double>(cells) / static_cast<double>(edge.size());
    const double most = mostTurn({{}, outline.noise, arc}, arc);
    if (std::abs(at(k + 1) - at(k)) <= most) continue;
    const double before = median({at(k + count - 2), at(k + count - 1), at(k)});
    const double beyond = median({at(k + 1), at(k + 2), at(k + 3)});
    edge[seen[k]] = std::abs(beyond - before) > most ? 1 : 0;
  }
  return edge;
}

}  // namespace

ShellEdges::ShellEdges(const PolarRing& ring, const ShellOutline& outline, double radius)
    : outline_(outline),
      edge_(edgesOf(outline, radius)),
      steps_(sharpSteps(ring, radius, outline.noise)),
      blur_(kBlur / radius) {}

double ShellEdges::runsOn(double direction, int way, double widest) const {
  return std::min(runsOnInOutline(direction, way, widest), runsToStep(direction, way, widest));
}

double ShellEdges::runsToStep(double direction, int way, double widest) const {
  double reach = widest;
  for (const SharpStep& step : steps_) {
    const double ahead = way * std::remainder(step.azimuth - direction, kTwoPi);
    if (ahead >= 0.0) reach = std::min(reach, std::max(0.0, ahead - blur_));
  }
  return reach;
}

double ShellEdges::stepsBetween(double from, double to) const {
  double height = 0.0;
  for (const SharpStep& step : steps_) {
    const double ahead = std::remainder(step.azimuth - 0.5 * (from + to), kTwoPi);
    if (std::abs(ahead) < 0.5 * (to - from)) height += step.height;
  }
  return height;
}

/// Up to the middle of the last cell before an edge, beyond which that may be seen.
double ShellEdges::runsOnInOutline(double direction, int way, double widest) const {
  const std::size_t count = edge_.size();
  std::size_t cell = ringCell(direction, count);
  if (std::isnan(outline_.radius[cell])) return widest;
  double reach = way * std::remainder(middleOfCell(cell, count) - direction, kTwoPi), last = reach;
  for (; reach < widest; reach += kTwoPi / static_cast<double>(count)) {
    if (std::isfinite(outline_.radius[cell])) last = reach;
    if (way > 0 && edge_[cell]) return std::clamp(last, 0.0, widest);
    cell = (cell + (way > 0 ? 1 : count - 1)) % count;
    if (way < 0 && edge_[cell]) return std::clamp(last, 0.0, widest);
  }
  return widest;
}

}  // namespace tank_datum
