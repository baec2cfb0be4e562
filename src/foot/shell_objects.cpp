#include "foot/shell_objects.h"

#include <cmath>
#include <cstddef>

#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Cells from one edge to the next; those between that show nothing are among them.
struct Run {
  std::size_t first, last;  ///< cells that show something; both below the count, so that last may be below first
  int before = 0;           ///< the way the radius jumps to it: 1 outwards, -1 inwards, 0 not at all
};

class Runs {
 public:
  explicit Runs(const ShellCells& cells) : cells_(cells) {
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < cells.radius.size(); ++i) {
      if (std::isfinite(cells.radius[i])) seen.push_back(i);
    }
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const std::size_t from = seen[(k + seen.size() - 1) % seen.size()];
      const int jump = jumpBetween(from, seen[k]);
      if (jump != 0 || runs_.empty()) {
        runs_.push_back({seen[k], seen[k], jump});
      } else {
        runs_.back().last = seen[k];
      }
    }
    if (runs_.size() > 1 && runs_.front().before == 0) join(runs_.size() - 1);
  }

  /// The shortest run with an edge of an object on both sides and fewer cells than `most`; the count of runs if none.
  std::size_t shortestObject(std::size_t most) const {
    std::size_t shortest = runs_.size(), length = most;
    for (std::size_t k = 0; k < runs_.size() && runs_.size() > 1; ++k) {
      if (runs_[k].before * runs_[next(k)].before >= 0 || lengthOf(runs_[k]) >= length) continue;
      shortest = k;
      length = lengthOf(runs_[k]);
    }
    return shortest;
  }

  /// How far a run stands off the cells some way before and after it, if the radius jumps that way to it and back [m].
  double standsOut(std::size_t k, int way) const {
    if (runs_[k].before != way || runs_[next(k)].before != -way) return 0.0;
    const Run& run = runs_[k];
    const double before = cells_.radius[run.first] - radiusBeside(run.first, cells_.radius.size() - 1);
    const double after = cells_.radius[run.last] - radiusBeside(run.last, 1);
    return std::min(way * before, way * after);
  }

  std::size_t size() const { return runs_.size(); }

  /// Calls visit(cell) for every cell of a run, those that show nothing among them.
  template <typename Visit>
  void cellsOf(std::size_t k, const Visit& visit) const {
    const std::size_t count = cells_.radius.size(), length = lengthOf(runs_[k]);
    for (std::size_t i = 0; i < length; ++i) visit((runs_[k].first + i) % count);
  }

  /// Takes a run out; those beside it are one where no edge parts them.
  void remove(std::size_t k) {
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(k));
    const std::size_t after = k % runs_.size(), before = (after + runs_.size() - 1) % runs_.size();
    runs_[after].before = jumpBetween(runs_[before].last, runs_[after].first);
    if (runs_.size() > 1 && runs_[after].before == 0) join(before);
  }

 private:
  /// Beyond cells at an edge that blend with both of its sides.
  double radiusBeside(std::size_t cell, std::size_t step) const {
    constexpr std::size_t kBlend = 3;  // cells that show something
    for (std::size_t seen = 0; seen < kBlend;) {
      cell = (cell + step) % cells_.radius.size();
      if (std::isfinite(cells_.radius[cell])) ++seen;
    }
    return cells_.radius[cell];
  }

  std::size_t next(std::size_t k) const { return (k + 1) % runs_.size(); }

  std::size_t cellsAhead(std::size_t from, std::size_t to) const {
    const std::size_t count = cells_.radius.size();
    return (to + count - from) % count;
  }

  std::size_t lengthOf(const Run& run) const { return cellsAhead(run.first, run.last) + 1; }

  int jumpBetween(std::size_t from, std::size_t to) const {
    const double jump = cells_.radius[to] - cells_.radius[from];
    const double most = mostTurn(cells_, static_cast<double>(cellsAhead(from, to)) * cells_.arc);
    return jump > most ? 1 : jump < -most ? -1 : 0;
  }

  /// Makes one run of this and the next.
  void join(std::size_t k) {
    runs_[k].last = runs_[next(k)].last;
    runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(next(k)));
  }

  const ShellCells& cells_;
  std::vector<Run> runs_;
};

}  // namespace

double mostTurn(const ShellCells& cells, double arc) {
  constexpr double kSteepest = 0.15, kNoises = 4.0;
  return kNoises * cells.noise + kSteepest * arc;
}

std::vector<double> withoutObjects(const ShellCells& cells) {
  const std::size_t count = cells.radius.size();
  std::vector<double> radius = cells.radius;
  Runs runs(cells);
  for (std::size_t k; (k = runs.shortestObject(count / 8)) < runs.size(); runs.remove(k)) {
    runs.cellsOf(k, [&](std::size_t cell) { radius[cell] = kUnknown; });
  }
  return radius;
}

std::vector<bool> partsBefore(const ShellCells& cells, bool inside, double thinnest) {
  const std::size_t count = cells.radius.size();
  std::vector<bool> before(count, false);
  std::size_t marked = 0, seen = 0;
  for (const double radius : cells.radius) seen += std::isfinite(radius) ? 1 : 0;
  const Runs runs(cells);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs.standsOut(k, inside ? -1 : 1) < thinnest) continue;
    runs.cellsOf(k, [&](std::size_t cell) {
      before[cell] = true;
      marked += std::isfinite(cells.radius[cell]) ? 1 : 0;
    });
  }
  if (2 * marked > seen) before.assign(count, false);
  return before;
}

}  // namespace tank_datum
