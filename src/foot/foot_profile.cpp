#include "foot/foot_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/statistics.h"
#include "foot/lowest_layer.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewest = 10;  // points that make a bin's median worth looking at

struct Line {
  double offset = 0, slope = 0;
  double at(double d) const { return offset + slope * d; }
};

double middle(const FootProfile& profile, std::size_t bin) { return (static_cast<double>(bin) + 0.5) * profile.bin; }

/// The heights above their station's datum of all points, by bins of d, with several threads.
std::vector<std::vector<double>> heightsByBin(const std::vector<std::vector<FootPoint>>& stations,
                                              const std::vector<double>& datum, double reach, double bin) {
  constexpr std::size_t kParts = 16;
  const auto bins = static_cast<std::size_t>(std::ceil(reach / bin));
  std::vector<std::vector<std::vector<double>>> parts(kParts, std::vector<std::vector<double>>(bins));
  forEachIndex(kParts, 0, [&](std::size_t part) {
    for (std::size_t s = stations.size() * part / kParts; s < stations.size() * (part + 1) / kParts; ++s) {
      if (!std::isfinite(datum[s])) continue;
      for (const FootPoint& p : stations[s]) {
        if (p.d >= 0.0 && p.d < reach && std::abs(p.z - datum[s]) < reach) {
          parts[part][std::min(bins - 1, static_cast<std::size_t>(p.d / bin))].push_back(p.z - datum[s]);
        }
      }
    }
  });
  std::vector<std::vector<double>> heights(bins);
  forEachIndex(bins, 0, [&](std::size_t i) {
    for (const auto& part : parts) heights[i].insert(heights[i].end(), part[i].begin(), part[i].end());
  });
  return heights;
}

void fillBins(FootProfile& profile, const std::vector<std::vector<FootPoint>>& stations,
              const std::vector<double>& datum, const FootScales& scales) {
  const double layer = std::max(2.0 * profile.bin, 6.0 * scales.shell_noise);
  auto heights = heightsByBin(stations, datum, scales.reach, profile.bin);
  for (auto* column : {&profile.height, &profile.spread, &profile.error}) column->assign(heights.size(), kUnknown);
  forEachIndex(heights.size(), 0, [&](std::size_t i) {
    std::vector<double>& values = heights[i];
    if (!values.empty()) keepLowestLayer(values, layer);
    if (values.size() < kFewest) return;
    profile.height[i] = median(values);
    profile.spread[i] = robustSigma(values, profile.height[i]);
    profile.error[i] = 1.2533 * std::max(profile.spread[i], 1e-6) / std::sqrt(values.size());
  });
}

/// Median of the slopes between bins far apart (Theil and Sen), and of the offsets: half of the bins but for the
/// corner's may lie off without moving it.
Line robustLine(const FootProfile& profile, std::size_t first, std::size_t last) {
  std::vector<double> slopes, offsets;
  const std::size_t apart = std::max<std::size_t>(1, (last - first) / 3);
  for (std::size_t i = first; i <= last; ++i) {
    for (std::size_t j = i + apart; j <= last; ++j) {
      const double slope = (profile.height[j] - profile.height[i]) / (static_cast<double>(j - i) * profile.bin);
      if (std::isfinite(slope)) slopes.push_back(slope);
    }
  }
  const double slope = median(slopes);
  for (std::size_t i = first; i <= last; ++i) {
    if (std::isfinite(profile.height[i])) offsets.push_back(profile.height[i] - slope * middle(profile, i));
  }
  return {median(offsets), slope};
}

/// Whether the section leaves, at this bin, the level of the bins just before it by more than points scatter.
bool stepsAt(const FootProfile& profile, std::size_t bin, std::size_t before) {
  constexpr double kStep = 0.0025;  // over two bins; the thinnest annular plates are 6 mm [m]
  constexpr double kRamp = 0.10;    // the steepest slope of a foundation surface [m/m]
  const double step = std::abs(profile.height[bin] - profile.height[before]);
  const double error = 3.0 * std::hypot(profile.error[bin], profile.error[before]);
  return step > kStep + kRamp * static_cast<double>(bin - before) * profile.bin + error;
}

/// The last bin before the section steps up or down for good: one stray bin is no step.
std::size_t lastBeforeStep(const FootProfile& profile, std::size_t first) {
  std::vector<std::size_t> seen;
  for (std::size_t i = first; i < profile.height.size(); ++i) {
    if (std::isfinite(profile.height[i])) seen.push_back(i);
  }
  for (std::size_t i = 1; i < seen.size(); ++i) {
    const std::size_t before = seen[i - std::min<std::size_t>(i, 2)];
    const bool stays = i + 1 == seen.size() || stepsAt(profile, seen[i + 1], before);
    if (stays && stepsAt(profile, seen[i], before)) return seen[i - std::min<std::size_t>(i, 2)];
  }
  return seen.empty() ? first : seen.back();
}

Surface surfaceEndingAt(const FootProfile& profile, std::size_t last, const Line& line, double noise) {
  constexpr double kWidestLip = 0.11;  // annular plates stand out 50 to 75 mm, now and then 100 [m]
  std::vector<double> beyond;
  for (std::size_t i = last + 2; i < profile.height.size() && beyond.size() < 8; ++i) {
    if (std::isfinite(profile.height[i])) beyond.push_back(profile.height[i] - line.at(middle(profile, i)));
  }
  if (beyond.empty() || std::abs(median(beyond)) < std::max(0.003, 2.0 * noise)) return Surface::Foundation;
  return middle(profile, last) <= kWidestLip ? Surface::AnnularPlate : Surface::Ringwall;
}

/// An annular plate lies on the ringwall, so its slope is that of the ringwall's top beyond it, where neither the shell
/// nor the plate's own edge blends into the points; level where no ringwall is seen.
double slopeBeyond(const FootProfile& profile, std::size_t plate_end, double reach) {
  constexpr double kThickest = 0.03;  // annular plate [m]
  const std::size_t first = plate_end + 1 + static_cast<std::size_t>(std::ceil(2.0 * profile.blur / profile.bin));
  if (first >= profile.height.size()) return 0.0;
  const std::size_t last = lastBeforeStep(profile, first);
  if (static_cast<double>(last - first) * profile.bin < 0.2 * reach) return 0.0;
  const double drop = profile.height[plate_end / 2] - profile.height[(first + last) / 2];
  return drop > 0.0 && drop < kThickest ? robustLine(profile, first, last).slope : 0.0;
}

/// Bins wide enough that one holds a hundred points on the average.
double widthOfBins(const std::vector<std::vector<FootPoint>>& stations, double reach) {
  double points = 0;
  for (const auto& station : stations) points += static_cast<double>(station.size());
  return 100.0 * reach / std::max(1.0, points);
}

struct Plateau {
  std::size_t first, last;
  double offset, misfit;
};

/// The part of the surface that is plainly it. Beams near the shell blend with it and lift the points, beams near an
/// outer edge lower them, and the far scanner's wide footprints reach into the middle of a narrow plate: from the bin
/// where the section runs most nearly parallel to the surface, out to where it is off by what can be told.
Plateau findPlateau(const FootProfile& profile, std::size_t first, std::size_t last) {
  const auto level = [&](std::size_t i) { return profile.height[i] - profile.slope * middle(profile, i); };
  const std::size_t reach = std::max<std::size_t>(1, std::min<std::size_t>(3, (last - first) / 4));
  std::size_t flattest = (first + last) / 2;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = first + reach; i + reach <= last; ++i) {
    const double gradient = std::abs(level(i + reach) - level(i - reach));
    if (gradient < least && std::isfinite(level(i))) least = gradient, flattest = i;
  }
  std::vector<double> around;
  for (std::size_t i = flattest - reach; i <= flattest + reach; ++i) {
    if (std::isfinite(level(i))) around.push_back(level(i));
  }
  const double height = median(around);
  const auto lies_on = [&](std::size_t i) {
    return !(std::abs(level(i) - height) > 3.0 * profile.error[i] + 0.1 * profile.noise);
  };
  // one stray bin does not end the surface, two in a row do
  std::size_t from = flattest, to = flattest;
  while (from > first && (lies_on(from - 1) || (from > first + 1 && lies_on(from - 2)))) --from;
  while (to < last && (lies_on(to + 1) || (to + 1 < last && lies_on(to + 2)))) ++to;
  double squares = 0, expected = 0, bins = 0;
  for (std::size_t i = first; i <= last; ++i) {
    if (!std::isfinite(level(i))) continue;
    bins += 1.0;
    if (i >= from && i <= to) continue;
    squares += (level(i) - height) * (level(i) - height);
    expected += profile.error[i] * profile.error[i];
  }
  return {from, to, height, std::sqrt(std::max(0.0, squares - expected) / bins)};
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

FootProfile stackProfile(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
                         const FootScales& scales) {
  FootProfile profile;
  profile.bin = std::max({scales.reach / 100.0, scales.shell_noise, widthOfBins(stations, scales.reach)});
  fillBins(profile, stations, datum, scales);
  const std::size_t bins = profile.height.size();
  const auto binOf = [&](double d) { return static_cast<std::size_t>(d / profile.bin); };
  std::size_t first = binOf(std::max(scales.weld, 3.0 * scales.shell_noise)) + 1;
  while (first < bins && !std::isfinite(profile.height[first])) ++first;
  if (first >= bins) return profile;
  // what is stacked right beside the shell may be stray points only: a surface is at least four bins wide
  std::size_t last = lastBeforeStep(profile, first);
  while (last < first + 3 && first < bins / 3) last = lastBeforeStep(profile, ++first);
  if (last < first + 3) return profile;
  std::vector<double> spreads;
  for (std::size_t i = first; i <= last; ++i) {
    if (std::isfinite(profile.spread[i])) spreads.push_back(profile.spread[i]);
  }
  profile.noise = std::max(median(spreads), 1e-7);
  profile.blur = 4.0 * scales.shell_noise;
  profile.edge = static_cast<double>(last + 1) * profile.bin;
  const Line own = robustLine(profile, first + (last - first) / 3, last);  // clear of the corner's blend
  profile.surface = last + 1 < bins ? surfaceEndingAt(profile, last, own, profile.noise) : Surface::Foundation;
  const bool plate = profile.surface == Surface::AnnularPlate;
  profile.slope = plate ? slopeBeyond(profile, last, scales.reach) : own.slope;
  last -= std::min(last - first - 3, static_cast<std::size_t>(std::ceil(profile.blur / profile.bin)));
  Plateau plateau = findPlateau(profile, first, last);
  if (plate) {  // one that leans is plain along its own slope only
    FootProfile leaning = profile;
    leaning.slope = own.slope;
    const Plateau wider = findPlateau(leaning, first, last);
    if (wider.last - wider.first > plateau.last - plateau.first + 1) plateau = wider, profile.slope = own.slope;
  }
  profile.offset = plateau.offset;
  profile.misfit = plateau.misfit;
  profile.band_from = static_cast<double>(plateau.first) * profile.bin;
  profile.band_to = static_cast<double>(plateau.last + 1) * profile.bin;
  return profile;
}

}  // namespace tank_datum
