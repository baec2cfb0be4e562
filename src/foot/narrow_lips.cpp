#include "foot/narrow_lips.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "foot/blurred_lips.h"
#include "foot/foot_roughness.h"
#include "foot/ring_slope.h"
#include "foot/shell_strip.h"

namespace tank_datum {
namespace {

/// The points of a strip between two heights that lie at its densest level.
std::vector<Beside> densestLevel(std::vector<Beside> points, double from, double to, double thick) {
  const auto outside = [&](const Beside& p) { return p.height < from || p.height > to; };
  points.erase(std::remove_if(points.begin(), points.end(), outside), points.end());
  std::sort(points.begin(), points.end(), [](const Beside& a, const Beside& b) { return a.height < b.height; });
  std::size_t first = 0, last = 0;
  for (std::size_t begin = 0, end = 0; begin < points.size(); ++begin) {
    while (end < points.size() && points[end].height <= points[begin].height + thick) ++end;
    if (end - begin > last - first) first = begin, last = end;
  }
  return {points.begin() + static_cast<std::ptrdiff_t>(first), points.begin() + static_cast<std::ptrdiff_t>(last)};
}

/// The width over which points lie evenly, without what noise scatters them by [m].
double widthOf(const std::vector<double>& distances, double noise) {
  const auto count = static_cast<double>(distances.size());
  double sum = 0.0, squares = 0.0;
  for (const double d : distances) sum += d, squares += d * d;
  const double variance = squares / count - square(sum / count) - square(noise);
  return std::sqrt(12.0 * std::max(0.0, variance));
}

/// How points from one distance to another rise outwards [m/m]; NaN of too few.
double slopeWithin(const std::vector<Beside>& points, double from, double to) {
  double count = 0.0, d = 0.0, height = 0.0, squares = 0.0, products = 0.0;
  for (const Beside& p : points) {
    if (p.d < from || p.d > to) continue;
    count += 1.0, d += p.d, height += p.height;
    squares += p.d * p.d, products += p.d * p.height;
  }
  return (count * products - d * height) / (count * squares - d * d);
}

/// How points of a level rise between a weld's toe and the face of an edge, which scans show more densely than what
/// lies between [m/m].
double slopeBetween(const std::vector<Beside>& level, const std::vector<double>& distances) {
  constexpr double kEnds = 0.05;               // of the points, which may be others
  constexpr double kToe = 0.35, kFace = 0.15;  // of the width
  const double first = quantile(distances, kEnds), last = quantile(distances, 1.0 - kEnds), width = last - first;
  return slopeWithin(level, first + kToe * width, last - kFace * width);
}

/// What hides the surface beside the shell.
struct Cover {
  Lift lift;
  double most = 0.0;    ///< that it may be high: its level's upper end [m]
  bool is_lip = false;  ///< else it may be a cable, or a fillet that slopes
};

/// A cover that may be so high.
Cover mayBe(double height) { return {{height, 0.0}, height, false}; }

/// Whether what covers the surface comes down to it as a fillet does: below a level points lie over a width, where an
/// edge's face is upright but for what noise and wide beams make of it. Upon a plate, where a weld is more likely than
/// a lip, what noise may make of either surface counts too.
/// @param height  of the level
bool comesDown(const ShellStrip& strip, const std::vector<Beside>& level, double height) {
  constexpr double kFewest = 0.2;   // of the level's points
  constexpr double kUpright = 0.5;  // what falls more steeply is a face [m/m]
  constexpr double kNoise = 2.0;    // standard deviations: nearer to either surface points may be of it
  const double least = kNoise * strip.noise, lowest = level.front().height,
               most = strip.on_plate ? lowest : std::min(lowest, height - kNoise * strip.noise);
  std::vector<double> distances;
  for (const Beside& p : strip.points) {
    if (p.height > least && p.height < most) distances.push_back(p.d);
  }
  return static_cast<double>(distances.size()) > kFewest * static_cast<double>(level.size()) &&
         kUpright * widthOf(distances, strip.blur) > most - least;
}

/// Whether points of a level lie on a lip: they do not fall as a fillet does, beyond their middle or before an edge's
/// face; and upon a plate, or where the face is all that falls, they are seen farther along than a cable of their
/// height.
bool isLip(const ShellStrip& strip, const std::vector<Beside>& level, const std::vector<double>& distances,
           double width, double height) {
  constexpr double kRound = 2.0;  // times its height: what is round is seen no wider
  if (comesDown(strip, level, height)) return false;
  const bool level_out = slopeWithin(level, median(distances), strip.to) >= -kSteepestLip;
  if (level_out && !strip.on_plate) return true;
  return width > kRound * height && (level_out || slopeBetween(level, distances) >= -kSteepestLip);
}

/// What may be where a strip shows nothing at all.
Cover unseenIn(const ShellStrip& strip, double reach) {
  return mayBe(std::min(unseenHeight(strip, reach), kHighestLip * reach));
}

/// What a strip shows; of no height where that is the surface.
Cover coverIn(const ShellStrip& strip, double reach) {
  constexpr double kSteepest = 0.5;  // a weld or a fillet is steeper [m/m]
  constexpr double kUnder = 0.25;    // of its points: others on the surface below, nearer to the shell
  constexpr double kLean = 0.03;     // of lips, usually [m/m]
  if (!strip.valid()) return {};
  const double thick = 4.0 * strip.noise;
  const double lowest = std::max(kLowestLip * reach, 0.75 * thick), highest = kHighestLip * reach;
  const std::vector<Beside> level = densestLevel(strip.points, lowest, highest, thick);
  const auto above =
      std::count_if(strip.points.begin(), strip.points.end(), [&](const Beside& p) { return p.height > highest; });
  const double chance =
      static_cast<double>(above) * thick / (kStripHigh * reach - highest);  // as of what noise moves there
  const auto count = static_cast<double>(level.size());
  if (level.empty() || count - chance < 3.0 * std::sqrt(count + chance)) return unseenIn(strip, reach);
  std::vector<double> heights, distances;
  for (const Beside& p : level) heights.push_back(p.height), distances.push_back(p.d);
  const double flat = (count - chance) * strip.width / strip.surface;  // as wide as so many points of the surface
  const double least = std::max(kNarrowestStrip * reach, thick / kSteepest), middle = median(distances);
  const double width = widthOf(distances, strip.blur), height = median(heights);
  if (flat < least || width < least) return unseenIn(strip, reach);
  const auto below = std::count_if(strip.points.begin(), strip.points.end(),
                                   [&](const Beside& p) { return p.d < middle && std::abs(p.height) < 0.5 * thick; });
  if (static_cast<double>(below) > kUnder * count) return {};
  return {{height, std::hypot(kLean * middle, strip.noise / std::sqrt(count))},
          level.back().height,
          isLip(strip, level, distances, width, height)};
}

/// How high above the surface the shell ends behind an edge: it stands out farther than a weld of that height, which
/// falls by 45 degrees; 0 where none does, and on a plate, which has a weld [m].
double edgeBeside(const ShellStrip& strip, double reach) {
  constexpr double kFewest = 8.0, kShare = 0.25;  // points that stand out so, and of all that stand there
  constexpr double kBlur = 5.0, kSurface = 2.0;   // standard deviations; two of them pass for the shell
  if (!strip.valid() || strip.on_plate) return 0.0;
  const double height = shellEndsAt(strip, reach);
  double standing = 0.0, beyond = 0.0;
  for (const Beside& p : strip.points) {
    if (p.height < kSurface * strip.noise || p.height > height) continue;
    standing += 1.0, beyond += p.d > height - p.height + kBlur * strip.blur;
  }
  return beyond >= kFewest && beyond > kShare * standing ? std::min(height, kHighestLip * reach) : 0.0;
}

/// What hides the surface beside the shell, or may: where no level shows it, an edge or noise.
Cover coverOf(const ShellStrip& strip, const BlurredRise& round_the_ring, double reach) {
  const Cover cover = coverIn(strip, reach);
  if (cover.lift.height > 0.0) return cover;
  return mayBe(std::max(edgeBeside(strip, reach), blurredLip(strip, round_the_ring, reach)));
}

/// The cover of the station of a run that has one nearest to one.
/// @param lips  whether only lips count
Cover nearestCover(const std::vector<Cover>& found, const RingRun& run, std::size_t station, bool lips) {
  const auto counts = [&](std::size_t k) {
    const Cover& cover = found[k % found.size()];
    return lips ? cover.is_lip : cover.lift.height > 0.0;
  };
  for (std::size_t away = 0; away <= run.last - run.first; ++away) {
    if (station + away <= run.last && counts(station + away)) return found[(station + away) % found.size()];
    if (station >= run.first + away && counts(station - away)) return found[(station - away) % found.size()];
  }
  return {};
}

/// The stations of a gap between parts of the ring: as those beside it, straight from one to the other.
void liftBetween(const RingRun& gap, std::vector<Lift>& lifts) {
  const std::size_t count = lifts.size();
  const Lift before = lifts[(gap.first + count - 1) % count], after = lifts[(gap.last + 1) % count];
  for (std::size_t k = gap.first; k <= gap.last; ++k) {
    const double share = static_cast<double>(k - gap.first + 1) / static_cast<double>(gap.last - gap.first + 2);
    lifts[k % count] = {(1.0 - share) * before.height + share * after.height,
                        std::hypot(std::max(before.sigma, after.sigma), kHolds * (before.height - after.height))};
  }
}

}  // namespace

std::vector<Lift> findNarrowLips(const Foot& foot, const std::vector<FootFit>& fits, const FootSections& sections) {
  constexpr double kNear = 5.0 * kDegree;
  const std::size_t count = fits.size();
  std::vector<ShellStrip> strips(count);
  std::vector<Cover> found(count);
  forEachIndex(count, 0, [&](std::size_t i) { strips[i] = stripAt(foot, i, fits[i], sections.at(i)); });
  const BlurredRise round_the_ring = blurredRise(strips, foot.reach);
  forEachIndex(count, 0, [&](std::size_t i) {
    if (fits[i].valid()) found[i] = coverOf(together(strips, i, foot), round_the_ring, foot.reach);
  });
  std::vector<char> valid(count);
  for (std::size_t i = 0; i < count; ++i) valid[i] = fits[i].valid() ? 1 : 0;
  std::vector<Lift> lifts(count);
  std::vector<char> between(count, 1);
  for (const RingRun& run : runsRound(valid, foot.stationsIn(kNear))) {
    std::size_t stand = 0, covered = 0, lips = 0;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      between[k % count] = 0;
      stand += valid[k % count] != 0;
      covered += found[k % count].lift.height > 0.0;
      lips += found[k % count].is_lip;
    }
    if (2 * covered <= stand) continue;
    const bool raised = 2 * lips > stand;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      const Cover cover = nearestCover(found, run, k, raised);
      const double doubted = !raised ? cover.most : found[k % count].is_lip ? 0.0 : cover.lift.height;
      lifts[k % count] = {raised ? cover.lift.height : 0.0, std::hypot(cover.lift.sigma, kHolds * doubted)};
    }
  }
  for (const RingRun& gap : runsRound(between)) liftBetween(gap, lifts);
  return lifts;
}

double usualLip(const std::vector<Lift>& lifts, const std::vector<FootFit>& fits) {
  std::vector<double> heights;
  std::size_t stand = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (!fits[i].valid()) continue;
    ++stand;
    if (lifts[i].height > 0.0) heights.push_back(lifts[i].height);
  }
  return 2 * heights.size() > stand ? median(heights) : 0.0;
}

}  // namespace tank_datum
