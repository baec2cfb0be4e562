#include "foot/shell_below.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/foot_roughness.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kLeast = 0.002;  // of the reach: what is lower by less is no other surface

/// How far below and above a level is seen at once beside a foot [m].
double depthBeside(const Foot& foot, const FootFit& level) {
  constexpr double kDepth = 0.04;  // of the reach
  return kDepth * foot.reach + leastBelow(foot, level);
}

/// Visits the points of the shell near a level with their heights above it.
template <typename Visit>
void visitShell(const Foot& foot, std::size_t station, const FootFit& level, double depth, Visit&& visit) {
  foot.ring.visitAround(foot.directions[station], level.half_width, level.z, depth, [&](const FootPoint& p) {
    if (std::abs(p.d) > 2.0 * foot.scales.shell_noise) return;
    visit(p.z - level.z - level.along * p.t - level.bend * p.t * p.t);
  });
}

/// What points scatter by about the surface, usually [m].
double noiseOf(const std::vector<FootFit>& fits) {
  std::vector<double> noises;
  for (const FootFit& fit : fits) {
    if (fit.valid()) noises.push_back(fit.noise);
  }
  return median(noises);
}

/// The counts of an arc's stations together, without the quarter that has most of the shell below: what a few see, at a
/// dip or beside soil, is not what all of them see.
ShellCounts withoutDeepest(std::vector<ShellCounts> arc) {
  constexpr std::size_t kPart = 4;
  const auto kept = arc.begin() + static_cast<std::ptrdiff_t>(arc.size() - arc.size() / kPart);
  std::nth_element(arc.begin(), kept, arc.end(), [](const ShellCounts& a, const ShellCounts& b) {
    return std::make_pair(a.below, a.above) < std::make_pair(b.below, b.above);
  });
  ShellCounts sum;
  std::for_each(arc.begin(), kept, [&sum](const ShellCounts& station) { sum.add(station); });
  return sum;
}

}  // namespace

double leastBelow(const Foot& foot, const FootFit& level) {
  return kLeast * foot.reach + 3.0 * std::hypot(level.sigma, level.noise);
}

bool ShellCounts::isGoodPart() const {
  constexpr double kShare = 0.25;
  return below > 0 && static_cast<double>(below) >= kShare * static_cast<double>(above);
}

bool ShellCounts::goOn() const {
  constexpr std::size_t kStray = 3;
  return below > kStray && isGoodPart();
}

ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level, double depth) {
  const double least = leastBelow(foot, level);
  ShellCounts counts;
  visitShell(foot, station, level, 2.0 * depth, [&](double height) {
    counts.below += height < -least && height > -depth;
    counts.above += height > least && height < depth;
  });
  return counts;
}

ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level) {
  return countShell(foot, station, level, depthBeside(foot, level));
}

FootFit levelAt(const Foot& foot, double z, double sigma) {
  FootFit level;
  level.z = z, level.sigma = sigma, level.along = level.bend = 0.0;
  level.noise = foot.scales.shell_noise, level.half_width = foot.half_step;
  return level;
}

std::vector<bool> findShellBelow(const Foot& foot, const std::vector<FootFit>& fits) {
  constexpr double kArc = 15.0 * kDegree;  // to either side, that is looked at together
  constexpr double kDeep = 0.03;           // of the reach, below and above what noise blurs
  constexpr double kBlur = 2.0;            // of the surface's noise
  constexpr double kChance = 2.0;          // standard deviations of the number of points below
  const std::size_t count = fits.size(), near = foot.stationsBeside(kArc);
  const double deep = kDeep * foot.reach, blur = kBlur * noiseOf(fits);
  std::vector<ShellCounts> own(count);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (!fits[i].valid()) return;
    FootFit level = fits[i];
    level.half_width = foot.half_step;
    visitShell(foot, i, level, 2.0 * (deep + blur), [&](double height) {
      own[i].below += height < -blur && height > -blur - deep;
      own[i].above += height > blur && height < blur + deep;
    });
  });
  std::vector<bool> goes_on(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!fits[i].valid()) continue;
    std::vector<ShellCounts> arc;
    std::vector<double> sigmas;
    for (std::size_t k = i + count - near; k <= i + count + near; ++k) {
      if (!fits[k % count].valid()) continue;
      arc.push_back(own[k % count]);
      sigmas.push_back(fits[k % count].sigma);
    }
    const ShellCounts most = withoutDeepest(std::move(arc));
    const auto below = static_cast<double>(most.below), above = static_cast<double>(most.above);
    const double least = kLeast * foot.reach + std::max(0.0, 3.0 * median(sigmas) - blur);
    goes_on[i] = (below - kChance * std::sqrt(below)) * deep > least * above;
  }
  return goes_on;
}

double shellSeenFrom(const Foot& foot, const std::vector<FootFit>& fits) {
  constexpr std::size_t kStray = 2, kFewest = 10;  // points of a station's stretch
  constexpr double kBefore = 0.1;                  // of the reach: legs and bands on a shell stand before it
  constexpr double kClear = 3.0;  // noises of the surface, which goes on below what stands before a shell
  std::vector<double> lowest(fits.size(), kUnknown);
  forEachIndex(fits.size(), 0, [&](std::size_t i) {
    const FootFit& fit = fits[i];
    if (!fit.valid()) return;
    const double behind = 2.0 * foot.scales.shell_noise, before = std::max(behind, kBefore * foot.reach);
    std::vector<double> heights;
    foot.ring.visitAround(foot.directions[i], foot.half_step, fit.z, foot.reach, [&](const FootPoint& p) {
      const double height = offOf(p, fit);
      if (p.d >= -behind && p.d <= before && height > kClear * fit.noise) heights.push_back(height);
    });
    if (heights.size() < kFewest) return;
    std::nth_element(heights.begin(), heights.begin() + kStray, heights.end());
    lowest[i] = heights[kStray];
  });
  return median(finiteOf(lowest));
}

double shareAboveShell(const Foot& foot, const std::vector<FootFit>& fits) {
  constexpr double kClear = 4.0, kShell = 2.0;  // of the shell's noise: off it, and to either side of it
  constexpr double kBeside = 0.1;               // of the reach: how far off it what lies as low is looked for
  constexpr double kChance = 2.0;               // standard deviations of a number of points
  constexpr double kFewest = 3.0;               // stations
  const double noise = foot.scales.shell_noise, clear = kClear * noise, far = clear + kBeside * foot.reach;
  std::vector<std::size_t> alone(fits.size()), behind(fits.size());
  forEachIndex(fits.size(), 0, [&](std::size_t i) {
    if (!fits[i].valid()) return;
    FootFit level = fits[i];
    level.half_width = foot.half_step;
    const double least = leastBelow(foot, level), depth = depthBeside(foot, level);
    std::size_t before = 0;
    foot.ring.visitAround(foot.directions[i], level.half_width, level.z, depth, [&](const FootPoint& p) {
      if (p.z >= level.z - least || std::abs(p.d) <= clear || std::abs(p.d) >= far) return;
      ++(p.d < 0.0 ? behind[i] : before);
    });
    alone[i] = before == 0 && countShell(foot, i, level, depth).below > 0 ? 1 : 0;
  });
  const auto sumOf = [](const std::vector<std::size_t>& counts) {
    return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t{0}));
  };
  const auto stand = std::count_if(fits.begin(), fits.end(), [](const FootFit& fit) { return fit.valid(); });
  if (stand == 0) return kUnknown;
  const double strays = sumOf(behind) * 2.0 * kShell * noise / (far - clear);
  const double stations = sumOf(alone) - strays - kChance * std::sqrt(strays);
  return stations < kFewest ? 0.0 : stations / static_cast<double>(stand);
}

}  // namespace tank_datum
