#include "foot/gussets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "core/parallel.h"
#include "core/units.h"
#include "fit/ring_cells.h"

namespace tank_datum {
namespace {

/// What is seen in a layer of a column: how far its points lie out from the shell [m].
struct Layer {
  int points = 0;
  double least = 0.0, most = 0.0;

  void add(double off) {
    least = points == 0 ? off : std::min(least, off);
    most = points == 0 ? off : std::max(most, off);
    ++points;
  }
};

/// What is seen in a column of the ring.
struct Column {
  std::size_t begin = 0, end = 0;  ///< its points
  int on = 0, out = 0;             ///< how many of them lie on the shell, and out from it
  int deep = 0, layers = 0;        ///< layers whose points lie at several distances out, of those that tell
};

}  // namespace

std::optional<PolarRing> withoutGussets(const PolarRing& ring, const ShellOutline& outline, const Tank& tank,
                                        const ShellHeights& heights) {
  constexpr double kWide = 0.04;  // of a column, of the heights: about a gusset's thickness
  constexpr double kFar = 0.1;    // out from the shell, of the heights
  constexpr double kDense = 0.5;  // of the points on the shell
  constexpr double kDeep = 0.03;  // points of a layer apart, of the heights: a wall that leans has them closer
  constexpr int kLayers = 8;
  constexpr int kFewest = 3;      // points of a gusset
  constexpr double kMost = 0.25;  // of the columns
  if (!outline.isResolved(heights.to)) return std::nullopt;
  const PolarPoints& points = ring.points();
  std::vector<Column> columns(1 + static_cast<std::size_t>(kTwoPi * tank.circle.radius / (kWide * heights.to)));
  const double on_shell = kOnShell * outline.noise, far = std::max(kFar * heights.to, 3.0 * on_shell);
  forEachIndex(columns.size(), 0, [&](std::size_t i) {
    Column& column = columns[i];
    std::tie(column.begin, column.end) = ring.inCell(i, columns.size());
    const double azimuth = middleOfCell(i, columns.size());
    const double foot = tank.foot(azimuth), shell = outline.at(azimuth);
    std::array<Layer, kLayers> layers{};
    for (std::size_t k = column.begin; k < column.end; ++k) {
      const double height = points[k].z - foot, off = points[k].radius - shell;
      if (height < heights.from || height > heights.to || !(off > -on_shell && off < far)) continue;
      ++(off < on_shell ? column.on : column.out);
      const double share = (height - heights.from) / (heights.to - heights.from);
      layers[static_cast<std::size_t>(std::min(share * kLayers, kLayers - 0.5))].add(off);
    }
    for (const Layer& layer : layers) {
      column.layers += layer.points > 1 ? 1 : 0;
      column.deep += layer.most - layer.least > kDeep * heights.to ? 1 : 0;
    }
  });
  const auto isSeen = [](const Column& c) { return c.on + c.out >= kFewest; };
  const auto isGusset = [](const Column& c) {
    return c.out >= kFewest && c.out >= kDense * c.on && 2 * c.deep > c.layers;
  };
  const auto gussets = static_cast<double>(std::count_if(columns.begin(), columns.end(), isGusset));
  const auto seen = static_cast<double>(std::count_if(columns.begin(), columns.end(), isSeen));
  if (gussets == 0.0 || gussets > kMost * seen) return std::nullopt;
  PolarPoints others;
  for (const Column& c : columns) {
    if (!isGusset(c)) others.insert(others.end(), points.data() + c.begin, points.data() + c.end);
  }
  return PolarRing(std::move(others));
}

}  // namespace tank_datum
