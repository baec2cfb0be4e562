#include "shell/shell_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circular_series.h"
#include "locate/side_sign.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Drops rows that are usually known far worse than the others: through the underside of a wind girder, which is level,
/// any radius fits.
void dropPoorRows(std::vector<std::vector<ShellCell>>& rows) {
  constexpr double kFar = 20.0;  // times the usual standard error
  std::vector<double> sigmas;
  for (const auto& row : rows) {
    const double usual = usualSigma(row);
    if (std::isfinite(usual)) sigmas.push_back(usual);
  }
  const double worst = std::max(kGoodSigma, kFar * median(std::move(sigmas)));
  for (auto& row : rows) {
    if (usualSigma(row) > worst) row.assign(row.size(), {});
  }
}

/// With height: plates are bent by some centimetres within a course.
double bendUp(double rise) { return 0.02 + 0.02 * std::min(rise, 2.0); }

/// Sets of cells that are joined (union-find).
class Parts {
 public:
  explicit Parts(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(b)] = of(a); }

 private:
  std::vector<std::size_t> parent_;
};

void joinAlong(const ShellGrid& grid, std::size_t k, Parts& parts) {
  const std::vector<ShellCell>& row = grid.cells[k];
  const std::size_t count = row.size(), first = k * count;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = nextSeen(row, i);
    if (!row[i].seen() || next == i + count) continue;
    if (runsToNext(row, i, next - i, grid.step)) parts.join(first + i, first + next % count);
  }
}

void joinUp(const ShellGrid& grid, std::size_t station, Parts& parts) {
  const std::size_t count = grid.cells.front().size();
  std::size_t below = grid.heights.size();  // none yet
  for (std::size_t k = 0; k < grid.heights.size(); ++k) {
    const ShellCell& cell = grid.cells[k][station];
    if (!cell.seen()) continue;
    if (below < k) {
      const double bend = bendUp(grid.heights[k] - grid.heights[below]);
      if (mayBeOne(cell, grid.cells[below][station], bend)) parts.join(below * count + station, k * count + station);
    }
    below = k;
  }
}

/// The part that the shell is.
std::size_t shellOf(const ShellGrid& grid, Parts& parts) {
  const std::size_t count = grid.cells.front().size();
  std::size_t from = 0, to = grid.cells.size() * count;  // cells that are looked at
  for (std::size_t k = 0; k < grid.cells.size(); ++k) {
    const std::vector<ShellCell>& row = grid.cells[k];
    if (2 * std::count_if(row.begin(), row.end(), [](const ShellCell& c) { return c.seen(); }) <
        static_cast<std::ptrdiff_t>(count))
      continue;
    from = k * count, to = from + count;
    break;
  }
  std::vector<std::size_t> sizes(grid.cells.size() * count, 0);
  for (std::size_t c = from; c < to; ++c) sizes[parts.of(c)] += grid.cells[c / count][c % count].seen() ? 1 : 0;
  return static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

}  // namespace

ShellGrid fitShellGrid(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                       const ShellOptions& options) {
  ShellGrid grid;
  grid.step = kTwoPi / static_cast<double>(stations.size()) * circle.radius;
  grid.side = bands.side();
  std::vector<double> elevations;
  for (const Station& s : stations) elevations.push_back(s.z);
  elevations = filledUp(elevations);
  std::vector<std::vector<ShellCell>> rows(bands.heights().size());
  forEachIndex(rows.size(), 0, [&](std::size_t k) {
    std::vector<double> z;
    for (const double elevation : elevations) z.push_back(elevation + bands.heights()[k]);
    rows[k] = fitShellRow(bands.points(k), stations, circle, z, {options.half_band, bands.side()});
  });
  dropPoorRows(rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (std::none_of(rows[k].begin(), rows[k].end(), [](const ShellCell& cell) { return cell.seen(); })) continue;
    grid.heights.push_back(bands.heights()[k]);
    grid.cells.push_back(std::move(rows[k]));
  }
  return grid;
}

void keepConnected(ShellGrid& grid) {
  if (grid.cells.empty()) return;
  const std::size_t count = grid.cells.front().size();
  Parts parts(grid.cells.size() * count);
  for (std::size_t k = 0; k < grid.cells.size(); ++k) joinAlong(grid, k, parts);
  for (std::size_t i = 0; i < count; ++i) joinUp(grid, i, parts);
  const std::size_t shell = shellOf(grid, parts);
  for (std::size_t k = 0; k < grid.cells.size(); ++k) {
    const std::vector<ShellCell> row = grid.cells[k];
    double radius = kUnknown;  // of the shell, as seen last round the ring
    for (std::size_t i = 0; i < 2 * count; ++i) {
      const ShellCell& cell = row[i % count];
      if (!cell.seen()) continue;
      if (parts.of(k * count + i % count) == shell) {
        radius = cell.radius;
        continue;
      }
      const bool behind = signOf(grid.side) * (cell.radius - radius) < 0.0;  // not where no shell is seen: NaN
      grid.cells[k][i % count] = {};
      if (behind) grid.cells[k][i % count].doubted = cell.radius;
    }
  }
}

}  // namespace tank_datum
