#include "shell/shell_plumbness.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/portable_math.h"
#include "core/units.h"
#include "fit/adaptive_smooth.h"
#include "shell/shell_bands.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// The weighted line radius = a + slope * height.
void fitLine(const std::vector<double>& heights, const std::vector<ShellCell>& cells, Plumbness& result) {
  double weights = 0, mean_height = 0, mean_radius = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double w = 1.0 / (cells[k].sigma * cells[k].sigma);
    weights += w, mean_height += w * heights[k], mean_radius += w * cells[k].radius;
  }
  mean_height /= weights, mean_radius /= weights;
  double squares = 0, product = 0, chi2 = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double w = 1.0 / (cells[k].sigma * cells[k].sigma), h = heights[k] - mean_height;
    squares += w * h * h, product += w * h * (cells[k].radius - mean_radius);
  }
  result.slope = product / squares;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double left = cells[k].radius - mean_radius - result.slope * (heights[k] - mean_height);
    chi2 += left * left / (cells[k].sigma * cells[k].sigma);
  }
  // a shell that is no straight line leaves more than its noise, and the slope is known that much worse
  if (cells.size() < 3) return;
  result.sigma_slope = std::sqrt(std::max(1.0, chi2 / static_cast<double>(cells.size() - 2)) / squares);
}

/// The arc that the neighbours' points come from too, in stations.
double sharedAt(const ShellGrid& grid, std::size_t station) {
  double shared = 1.0;
  for (const auto& row : grid.cells) {
    if (row[station].seen()) shared = std::max(shared, row[station].shared);
  }
  return shared;
}

/// Smooths the offsets over one and the same height; those over another are as if not seen.
void smoothOver(double height, const ShellGrid& grid, std::vector<Plumbness>& all) {
  constexpr double kWidest = 15.0 / 360.0;  // half the arc, of a turn
  std::vector<SeriesValue> series;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double offset = all[i].height == height ? all[i].offset : kUnknown;
    series.push_back({offset, all[i].sigma, sharedAt(grid, i)});
  }
  series = smoothed(series, static_cast<std::size_t>(kWidest * static_cast<double>(all.size())));
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].height == height) all[i].offset = series[i].value, all[i].sigma = series[i].sigma;
  }
}

}  // namespace

Plumbness plumbnessAt(const ShellGrid& grid, std::size_t station, const Station& place) {
  Plumbness result;
  result.azimuth = place.azimuth;
  result.direction = place.direction;
  std::vector<double> heights;
  std::vector<ShellCell> cells;
  for (std::size_t k = 0; k < grid.heights.size(); ++k) {
    if (!grid.cells[k][station].seen()) continue;
    heights.push_back(grid.heights[k]);
    cells.push_back(grid.cells[k][station]);
  }
  if (cells.size() < 2) return result;
  result.height = heights.back() - heights.front();
  result.top = heights.back();
  result.offset = cells.back().radius - cells.front().radius;
  result.sigma = std::hypot(cells.back().sigma, cells.front().sigma);
  fitLine(heights, cells, result);
  return result;
}

std::vector<Plumbness> plumbnessOf(const ShellGrid& grid, const std::vector<Station>& stations) {
  std::vector<Plumbness> all;
  std::set<double> heights;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    all.push_back(plumbnessAt(grid, i, stations[i]));
    if (std::isfinite(all.back().offset)) heights.insert(all.back().height);
  }
  for (const double height : heights) smoothOver(height, grid, all);
  all.erase(std::remove_if(all.begin(), all.end(), [](const Plumbness& p) { return std::isnan(p.offset); }), all.end());
  return all;
}

}  // namespace tank_datum
