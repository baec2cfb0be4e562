#include "locate/step_back.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/statistics.h"

namespace tank_datum {
namespace {

/// Hits of a wall that stands upright, by height: at least half of what is seen at a voxel's height lies beside them.
/// The ground before it and the top of a ringwall spread outwards.
std::vector<Hit> uprightOf(std::vector<Hit> hits, double voxel, double least) {
  sortByHeight(hits);
  std::size_t kept = 0;
  std::vector<double> offs;
  for (std::size_t first = 0, end = 0; first < hits.size(); first = end) {
    offs.clear();
    for (; end < hits.size() && hits[end].z < hits[first].z + voxel; ++end) offs.push_back(hits[end].off);
    std::sort(offs.begin(), offs.end());
    for (std::size_t i = first; i < end; ++i) {
      const auto from = std::lower_bound(offs.begin(), offs.end(), hits[i].off - 0.5 * least);
      const auto to = std::upper_bound(from, offs.end(), hits[i].off + 0.5 * least);
      if (2 * (to - from) >= static_cast<std::ptrdiff_t>(offs.size())) hits[kept++] = hits[i];
    }
  }
  hits.resize(kept);
  return hits;
}

/// Sums over hits.
struct Sums {
  double n = 0, z = 0, off = 0, zz = 0, zo = 0;

  void add(double dz, double doff) { n += 1.0, z += dz, off += doff, zz += dz * dz, zo += dz * doff; }
  Sums minus(const Sums& other) const {
    return {n - other.n, z - other.z, off - other.off, zz - other.zz, zo - other.zo};
  }
  double spread() const { return zz - z * z / n; }
  double product() const { return zo - z * off / n; }
  double lean() const { return spread() > 0.0 ? product() / spread() : 0.0; }
};

/// A wall in two pieces, with their means and leans. The face of the lower one may be battered; else they lean alike.
struct TwoPieces {
  double lower_z = 0, lower_off = 0, lower_lean = 0;
  double upper_z = 0, upper_off = 0, upper_lean = 0;

  TwoPieces(const Sums& lower, const Sums& upper) {
    lower_z = lower.z / lower.n, lower_off = lower.off / lower.n, lower_lean = lower.lean();
    upper_z = upper.z / upper.n, upper_off = upper.off / upper.n, upper_lean = upper.lean();
    if (!(lower_lean > upper_lean)) return;
    const double spread = lower.spread() + upper.spread();
    lower_lean = upper_lean = spread > 0.0 ? (lower.product() + upper.product()) / spread : 0.0;
  }
  /// How far the lower one stands out at a height.
  double apart(double z) const { return lowerAt(z) - upperAt(z); }
  double upperAt(double z) const { return upper_off + upper_lean * (z - upper_z); }
  double lowerAt(double z) const { return lower_off + lower_lean * (z - lower_z); }
};

/// Sums over the first hits, none of them, one and so on, about the lowest.
std::vector<Sums> runningSums(const std::vector<Hit>& run) {
  std::vector<Sums> sums(run.size() + 1);
  for (std::size_t i = 0; i < run.size(); ++i) {
    sums[i + 1] = sums[i];
    sums[i + 1].add(run[i].z - run[0].z, run[i].off - run[0].off);
  }
  return sums;
}

/// The first hit from a height on.
std::size_t firstFrom(const std::vector<Hit>& run, double height) {
  const auto first = std::partition_point(run.begin(), run.end(), [height](const Hit& hit) { return hit.z < height; });
  return static_cast<std::size_t>(first - run.begin());
}

}  // namespace

double medianOf(const std::vector<StepBack>& steps, double (*value)(const StepBack&)) {
  std::vector<double> values;
  for (const StepBack& step : steps) {
    if (step.found()) values.push_back(value(step));
  }
  return median(std::move(values));
}

StepBack findStepBack(std::vector<Hit> hits, double voxel, double least) {
  constexpr double kClear = 0.2;      // of what the pieces are apart: a wall that leans or bends has no step
  constexpr double kRows = 0.25;      // rows of a scan on a wall are no farther apart [m]
  constexpr double kRoof = 0.5;       // no wall leans by so much: a roof behind the top of a low tank does [m/m]
  constexpr std::size_t kFewest = 2;  // hits above: a single one may lie on a roof
  const std::vector<Hit> run =
      longestRun(uprightOf(std::move(hits), voxel, least), std::max(kHoleInVoxels * voxel, kRows));
  if (run.empty()) return {};
  const std::vector<Sums> sums = runningSums(run);
  const Hit& lowest = run.front();
  const double top = run.back().z, piece = kFewestVoxels * voxel;
  StepBack step;
  double least_scatter = HUGE_VAL, lower_top = 0.0;
  std::size_t above = 0;
  for (double height = lowest.z + piece + 0.25 * voxel; height <= std::min(lowest.z + kHighestRingwall, top);
       height += 0.5 * voxel) {
    const std::size_t middle = firstFrom(run, height),
                      end = firstFrom(run, height + std::max(height - lowest.z, piece));
    if (middle == 0 || middle == end) continue;
    const Sums upper = sums[end].minus(sums[middle]);
    const TwoPieces pieces(sums[middle], upper);
    const double between = 0.5 * (run[middle - 1].z + run[middle].z) - lowest.z, apart = pieces.apart(between);
    if (!(apart > least) || std::abs(upper.lean()) > kRoof) continue;
    double scatter = 0.0;
    for (std::size_t i = 0; i < end; ++i) {
      const double z = run[i].z - lowest.z;
      scatter += std::abs(run[i].off - lowest.off - (i < middle ? pieces.lowerAt(z) : pieces.upperAt(z)));
    }
    scatter /= static_cast<double>(end);
    if (scatter > std::min(least_scatter, kClear * apart)) continue;
    least_scatter = scatter;
    above = end - middle, lower_top = run[middle - 1].z;
    step = {lowest.z + between, lowest.off + pieces.upperAt(between), apart, lowest.z, top, scatter};
  }
  return lower_top <= top - piece && above >= kFewest ? step : StepBack{};
}

}  // namespace tank_datum
