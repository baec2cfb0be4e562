#include "foot/section_end.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "foot/section_lines.h"
#include "foot/section_stretches.h"

namespace tank_datum {
namespace {

/// A line of known slope through the inner half of some bins.
BinLine innerLine(const FootProfile& profile, std::size_t first, std::size_t last, double slope) {
  std::vector<double> offsets;
  for (std::size_t i = first; i <= (first + last) / 2; ++i) {
    const double offset = profile.height[i] - slope * middle(profile, i);
    if (std::isfinite(offset)) offsets.push_back(offset);
  }
  return {median(offsets), slope};
}

/// Whether what lies beyond a surface's last bin is not on its line; it is on none that too few bins tell.
bool stepsOff(const FootProfile& profile, std::size_t last, const BinLine& line) {
  std::vector<double> beyond;
  for (std::size_t i = last + 2; i < profile.height.size() && beyond.size() < 8; ++i) {
    if (std::isfinite(profile.height[i])) beyond.push_back(std::abs(profile.height[i] - line.at(middle(profile, i))));
  }
  // below it in a gap and above it on the crown beyond is off it too
  return !beyond.empty() && !(median(beyond) < std::max(0.003, 2.0 * profile.noise));
}

/// What the number of a bin's points is proportional to, as they scatter more than their median; NaN where it is not
/// seen.
double countIn(const FootProfile& profile, std::size_t bin) { return square(profile.spread[bin] / profile.error[bin]); }

/// Whether what is seen between two bins lies far thinner than a plate before it. Beams that meet an edge and something
/// else leave points between the two, where there is no surface.
bool isThin(const FootProfile& profile, std::size_t plate_end, std::size_t first, std::size_t last) {
  // of the plate's density; where only arcs whose plate is seen are stacked, that is above the average
  constexpr double kThin = 0.25;
  std::vector<double> plate, beyond;
  for (std::size_t i = 0; i <= last; ++i) {
    if (!std::isfinite(profile.height[i]) || (i > plate_end && i < first)) continue;
    (i <= plate_end ? plate : beyond).push_back(countIn(profile, i));
  }
  return median(beyond) < kThin * median(plate);
}

/// The last bin of a surface that may end in points of an upright face, too few for a step.
/// @param deep  what lies lower than the surface by that is a face's [m]
std::size_t lastAboveFace(const FootProfile& profile, std::size_t first, std::size_t last, double deep) {
  const auto begin = profile.height.begin();
  const double level = median(finiteOf({begin + static_cast<std::ptrdiff_t>(first),  //
                                        begin + static_cast<std::ptrdiff_t>(last) + 1}));
  while (last > first && !(profile.height[last] > level - deep)) --last;
  return last;
}

/// Whether anything is seen beyond a bin.
bool isSeenBeyond(const FootProfile& profile, std::size_t last) {
  return std::any_of(profile.height.begin() + static_cast<std::ptrdiff_t>(last) + 1, profile.height.end(),
                     [](double z) { return std::isfinite(z); });
}

/// The slope between two edges, where beams that meet one of them too do not reach; level, with what tops of ringwalls
/// have for its error, where that tells no better.
SlopeBeyond slopeBetweenEdges(const FootProfile& profile, std::size_t first, std::size_t last) {
  constexpr double kClear = 0.030;  // of an edge [m]
  constexpr double kTop = 0.05;     // of ringwalls, which drain [m/m]
  std::vector<SectionBin> bins;
  for (std::size_t i = first; i <= last; ++i) {
    const double d = middle(profile, i), z = profile.height[i];
    const bool clear = d > middle(profile, first) + kClear && d < middle(profile, last) - kClear;
    if (clear && std::isfinite(z)) bins.push_back({d, z, profile.error[i]});
  }
  if (bins.empty()) return {0.0, kTop};
  const SectionLine line = lineThrough(withErrorsSeen(bins), {0, bins.size()}, kTop);
  const double sigma = std::sqrt(line.variance_slope);
  return sigma < kTop ? SlopeBeyond{line.slope, sigma} : SlopeBeyond{0.0, kTop};
}

}  // namespace

BinLine robustLine(const FootProfile& profile, std::size_t first, std::size_t last) {
  std::vector<WeightedValue> slopes, offsets;
  const std::size_t apart = std::max<std::size_t>(1, (last - first) / 3);
  for (std::size_t i = first; i <= last; ++i) {
    for (std::size_t j = i + apart; j <= last; ++j) {
      const double length = static_cast<double>(j - i) * profile.bin;
      const double slope = (profile.height[j] - profile.height[i]) / length;
      if (std::isfinite(slope)) slopes.push_back({slope, length / std::hypot(profile.error[i], profile.error[j])});
    }
  }
  const double slope = weightedMedian(std::move(slopes));
  for (std::size_t i = first; i <= last; ++i) {
    const double offset = profile.height[i] - slope * middle(profile, i);
    if (std::isfinite(offset)) offsets.push_back({offset, 1.0 / profile.error[i]});
  }
  return {weightedMedian(std::move(offsets)), slope};
}

std::size_t lastBeforeStep(const FootProfile& profile, std::size_t first) {
  constexpr double kStep = 0.0025;  // the thinnest annular plates are 6 mm [m]
  constexpr double kLength = 0.06;  // of the lines on either side [m]
  std::vector<std::size_t> seen;
  std::vector<SectionBin> bins;
  for (std::size_t i = first; i < profile.height.size(); ++i) {
    if (!std::isfinite(profile.height[i])) continue;
    seen.push_back(i);
    bins.push_back({middle(profile, i), profile.height[i], profile.error[i]});
  }
  if (seen.empty()) return first;
  const StepScales scales{kStep, 2.0 * profile.blur, kLength};
  const std::size_t before = binsBeforeStep(bins, scales);
  return before == seen.size() ? seen.back() : seen[before] - 1;  // the surface may go on where none is seen
}

Surface surfaceOf(const FootProfile& profile, std::size_t first, std::size_t last, const BinLine& own,
                  const FootScales& scales) {
  constexpr double kWidestLip = 0.11;  // annular plates stand out 50 to 75 mm, now and then 100 [m]
  if (last + 1 >= profile.height.size()) return Surface::Foundation;
  const bool steps = stepsOff(profile, last, own);
  if (middle(profile, last) > kWidestLip) return steps ? Surface::Ringwall : Surface::Foundation;
  if (steps || scales.arc) return steps ? Surface::AnnularPlate : Surface::Foundation;
  // an edge that is blurred looks like a surface that leads to what lies beyond: the inner half does not lead there
  const BinLine inner = innerLine(profile, first, last, slopeBeyond(profile, last, scales.reach).slope);
  return stepsOff(profile, last, inner) ? Surface::AnnularPlate : Surface::Foundation;
}

SlopeBeyond slopeBeyond(const FootProfile& profile, std::size_t plate_end, double reach) {
  constexpr double kFace = 0.5;  // what is steeper is the upright face of something [m/m]
  const std::size_t first = plate_end + 1 + static_cast<std::size_t>(std::ceil(2.0 * profile.blur / profile.bin));
  if (first >= profile.height.size()) return {};
  const std::size_t last = lastAboveFace(profile, first, lastBeforeStep(profile, first), kThickestPlate);
  if (static_cast<double>(last - first) * profile.bin < 0.2 * reach) return {};
  const double drop = profile.height[plate_end / 2] - profile.height[(first + last) / 2];
  if (!(drop > 0.0 && drop < kThickestPlate)) return {};
  if (isThin(profile, plate_end, first, last)) return {};
  const SlopeBeyond top = isSeenBeyond(profile, last) ? slopeBetweenEdges(profile, first, last)
                                                      : SlopeBeyond{robustLine(profile, first, last).slope, 0.0};
  return std::abs(top.slope) < kFace ? top : SlopeBeyond{};
}

double dropBeyond(const FootProfile& profile) {
  constexpr double kFrom = 1.5, kTo = 2.5;  // times the edge's distance, where what lies beyond is looked at
  if (profile.surface != Surface::AnnularPlate) return 0.0;
  std::vector<double> beyond;
  for (std::size_t i = 0; i < profile.height.size(); ++i) {
    const double d = middle(profile, i);
    if (d > kFrom * profile.edge && d < kTo * profile.edge && std::isfinite(profile.height[i]))
      beyond.push_back(profile.offset - profile.height[i]);
  }
  return beyond.empty() ? 0.0 : median(beyond);
}

double heightOfPipe(const FootProfile& profile, double reach) {
  constexpr double kRound = 1.5;     // times its height: lips stand out farther
  constexpr double kFlat = 0.5;      // of what stands out, if that is set back: a lip, and no pipe
  constexpr double kHighest = 0.12;  // of the reach
  const double height = dropBeyond(profile);
  const bool on_grout = profile.overhang > 0.0 && profile.band_to - profile.band_from > kFlat * profile.edge;
  return height < kHighest * reach && profile.edge < kRound * height && !on_grout ? height : 0.0;
}

}  // namespace tank_datum
