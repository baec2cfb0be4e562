#include "foot/foot_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "foot/ring_slope.h"
#include "foot/section_bins.h"
#include "foot/section_end.h"
#include "foot/section_lines.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

struct Plateau {
  std::size_t first, last;
  double offset, misfit;
};

/// How far a bin lies above a line through the shell at the surface's slope [m].
double levelOf(const FootProfile& profile, std::size_t bin) {
  return profile.height[bin] - profile.slope * middle(profile, bin);
}

/// Bins to either side of one that lies on the surface as it does, out to where it is off by what can be told.
Plateau plateauAbout(const FootProfile& profile, std::size_t bin, std::size_t reach, BinRange surface) {
  std::vector<double> around;
  for (std::size_t i = bin - reach; i <= bin + reach; ++i) {
    if (std::isfinite(levelOf(profile, i))) around.push_back(levelOf(profile, i));
  }
  const double height = median(around);
  const auto lies_on = [&](std::size_t i) {
    return !(std::abs(levelOf(profile, i) - height) > 3.0 * profile.error[i] + 0.1 * profile.noise);
  };
  // one stray bin does not end the surface, two in a row do
  const auto [first, last] = surface;
  std::size_t from = bin, to = bin;
  while (from > first && (lies_on(from - 1) || (from > first + 1 && lies_on(from - 2)))) --from;
  while (to < last && (lies_on(to + 1) || (to + 1 < last && lies_on(to + 2)))) ++to;
  return {from, to, height, 0.0};
}

/// What bins outside of the plateau are off by, beyond their errors [m].
double misfitOf(const FootProfile& profile, const Plateau& plateau, BinRange surface) {
  double squares = 0, expected = 0, bins = 0;
  for (std::size_t i = surface.first; i <= surface.last; ++i) {
    if (!std::isfinite(levelOf(profile, i))) continue;
    bins += 1.0;
    if (i >= plateau.first && i <= plateau.last) continue;
    squares += square(levelOf(profile, i) - plateau.offset);
    expected += profile.error[i] * profile.error[i];
  }
  return std::sqrt(std::max(0.0, squares - expected) / bins);
}

/// The part of the surface that is plainly it. Beams near the shell blend with it and lift the points, beams near an
/// outer edge lower them, and the far scanner's wide footprints reach into the middle of a narrow plate: from the bin
/// where the section runs most nearly parallel to the surface. Where that is a small part of a foundation, the widest
/// that begins no farther out: ground about an object may run parallel too. (What slopes more may be a lip and a
/// crown.)
Plateau findPlateau(const FootProfile& profile, std::size_t first, std::size_t last) {
  constexpr double kUsualSlope = 0.05;  // [m/m]
  const BinRange surface{first, last};
  const std::size_t reach = std::max<std::size_t>(1, std::min<std::size_t>(3, (last - first) / 4));
  std::size_t flattest = (first + last) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first + reach; i + reach <= last; ++i) {
    const double gradient = std::abs(levelOf(profile, i + reach) - levelOf(profile, i - reach));
    if (gradient < least && std::isfinite(levelOf(profile, i))) least = gradient, flattest = i;
  }
  Plateau plateau = plateauAbout(profile, flattest, reach, surface);
  if (std::abs(profile.slope) < kUsualSlope && 2 * (plateau.last - plateau.first) < last - first) {
    for (std::size_t i = first + reach; i + reach <= last; ++i) {
      const Plateau other = plateauAbout(profile, i, reach, surface);
      if (other.first <= plateau.first && other.last - other.first > plateau.last - plateau.first) plateau = other;
    }
  }
  plateau.misfit = misfitOf(profile, plateau, surface);
  return plateau;
}

/// The first bin from one on that is seen.
std::size_t firstSeen(const FootProfile& profile, std::size_t from) {
  while (from < profile.height.size() && !std::isfinite(profile.height[from])) ++from;
  return from;
}

/// The first one where a surface is: of four bins it is seen in three, stray points are in fewer.
std::size_t firstOfSurface(const FootProfile& profile, std::size_t from) {
  const std::vector<double>& height = profile.height;
  for (std::size_t i = from; i + 4 <= height.size(); ++i) {
    const auto seen = [](double z) { return std::isfinite(z); };
    const auto at = height.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::isfinite(*at) && std::count_if(at, at + 4, seen) >= 3) return i;
  }
  return from;
}

/// The last bin up to which a surface is seen: of four bins it is seen in three, stray points beyond it are in fewer.
std::size_t lastOfSurface(const FootProfile& profile, std::size_t first, std::size_t last) {
  for (std::size_t i = last; i >= first + 3; --i) {
    const auto at = profile.height.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::isfinite(*at) && std::count_if(at - 3, at + 1, [](double z) { return std::isfinite(z); }) >= 3) return i;
  }
  return last;
}

/// Reads the surface between two bins: noise, edge, kind, slope, and the band that is plainly it, with what is not seen
/// next to it.
void readSurface(FootProfile& profile, std::size_t first, std::size_t last, const FootScales& scales) {
  const double reach = scales.reach;
  const std::size_t nearest = firstBeyondWeld(profile, scales);
  std::vector<double> spreads;
  for (std::size_t i = first; i <= last; ++i) {
    if (std::isfinite(profile.spread[i])) spreads.push_back(profile.spread[i]);
  }
  profile.noise = std::max(median(spreads), 1e-7);
  profile.edge = static_cast<double>(last + 1) * profile.bin;
  last = lastOfSurface(profile, first, last);
  const BinLine own = robustLine(profile, first + (last - first) / 3, last);  // clear of the corner's blend
  profile.surface = surfaceOf(profile, first, last, own, scales);
  const bool plate = profile.surface == Surface::AnnularPlate;
  const SlopeBeyond beyond = plate ? slopeBeyond(profile, last, reach) : SlopeBeyond{};
  profile.slope_beyond = beyond.slope, profile.sigma_beyond = beyond.sigma;
  profile.slope = plate ? profile.slope_beyond : own.slope;
  last -= std::min(last - first - 3, static_cast<std::size_t>(std::ceil(profile.blur / profile.bin)));
  Plateau plateau = findPlateau(profile, first, last);
  const auto leanBy = [&](double slope) {
    if (std::abs(slope) >= kSteepestLip) return;
    FootProfile leaning = profile;
    leaning.slope = slope;
    const Plateau wider = findPlateau(leaning, first, last);
    if (wider.last - wider.first > plateau.last - plateau.first + 1) plateau = wider, profile.slope = slope;
  };
  // one that leans is plain along its own slope only; what is lower beside the shell no beam has drawn down
  if (plate) {
    leanBy(own.slope);
    const double inwards = robustLine(profile, first, last).slope;
    if (inwards > std::max(0.0, own.slope)) leanBy(inwards);
  }
  profile.offset = plateau.offset;
  profile.misfit = plateau.misfit;
  while (plateau.first > nearest && !std::isfinite(profile.height[plateau.first - 1])) --plateau.first;
  profile.band_from = static_cast<double>(plateau.first) * profile.bin;
  profile.band_to = static_cast<double>(plateau.last + 1) * profile.bin;
}

/// The last bin of a plate whose edge does not follow the shell and so comes down over many bins, or ends at a step
/// that first elevations blur, where the band lies on the ringwall beyond; 0 where what is nearest to the shell lies on
/// the band's line, or comes down to it close to the shell as a blend does, more steeply than a lip. A blend comes down
/// from the shell on; a lip is level there, and its edge alone comes down steeply.
std::size_t lastOfRaised(const FootProfile& profile, std::size_t first, double reach) {
  constexpr double kFar = 0.2;      // of the reach
  constexpr double kStep = 0.0025;  // as of an edge that is sharp [m]
  constexpr double kSunk = 0.0012;  // below the band's line: no beam draws points down there [m]
  const auto begin = static_cast<std::size_t>(std::lround(profile.band_from / profile.bin));
  if (!profile.valid() || begin <= first + 3) return 0;
  const std::size_t half = (first + begin) / 2;
  const auto steep = [&](std::size_t from, std::size_t to) {
    return std::abs(robustLine(profile, from, to).slope) > kSteepestLip;
  };
  const bool blend = steep(first + (begin - first) / 3, begin - 1) && steep(first, half);
  if (profile.band_from < kFar * reach && blend) return 0;
  std::vector<double> above;
  for (std::size_t i = first; i < half; ++i) {
    if (std::isfinite(profile.height[i])) {
      above.push_back(profile.height[i] - profile.offset - profile.slope * middle(profile, i));
    }
  }
  const double off = median(above);
  return above.size() >= 4 && (off > kStep || off < -kSunk) ? begin - 1 : 0;
}

}  // namespace

const char* nameOf(Surface surface) {
  switch (surface) {
    case Surface::Unknown:
      return "unknown";
    case Surface::Foundation:
      return "foundation";
    case Surface::AnnularPlate:
      return "annular_plate";
    case Surface::Ringwall:
      return "ringwall";
  }
  return "";
}

double seenTo(const FootProfile& lip) {
  auto last = static_cast<std::size_t>(std::lround(lip.edge / lip.bin));
  while (last > 0 && !std::isfinite(lip.height[last - 1])) --last;
  return static_cast<double>(last) * lip.bin;
}

FootProfile stackProfile(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
                         const FootScales& scales) {
  constexpr double kUnseen = 0.15;  // of the reach
  FootProfile profile;
  profile.blur = scales.blur();
  stackBins(profile, stations, datum, scales);
  const std::size_t bins = profile.height.size();
  std::size_t first = firstSeen(profile, firstBeyondWeld(profile, scales));
  if (first >= bins) return profile;
  // what is stacked right beside the shell may be stray points only: a surface is at least four bins wide
  std::size_t last = lastBeforeStep(profile, first);
  while (last < first + 3 && first < bins / 3) last = lastBeforeStep(profile, ++first);
  // a lip would be hidden in what is not seen, or a gutter: the surface beyond is not known to reach the shell
  const double nearest = static_cast<double>(firstOfSurface(profile, first)) * profile.bin;
  if (nearest > scales.nearest() + kUnseen * scales.reach) profile.unseen = nearest;
  if (profile.unseen > 0.0 || last < first + 3) return profile;
  readSurface(profile, first, last, scales);
  const std::size_t end = lastOfRaised(profile, first, scales.reach);
  if (end >= first + 3) readSurface(profile, first, end, scales);
  return profile;
}

}  // namespace tank_datum
