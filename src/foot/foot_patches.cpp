#include "foot/foot_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

constexpr std::size_t kParts = 15;  // of a band, across it
constexpr double kStrip = 0.05;     // along the shell, in which points lie beside each other [m]

using Lags = std::array<double, kParts>;  // by how many parts of the band two points are apart

/// What pairs of points share that lie beside each other along the shell.
struct SharedAcross {
  Lags products{}, pairs{};

  void add(const FittedPoints& fitted, const FootProfile& profile) {
    struct Part {
      double sum = 0, squares = 0, count = 0;
    };
    const double width = (profile.band_to - profile.band_from) / static_cast<double>(kParts);
    std::map<long, std::array<Part, kParts>> strips;
    for (const FootPoint& p : fitted.points) {
      const double off = offOf(p, fitted.fit);
      if (!isOfBand(p, off, fitted.fit, profile)) continue;
      const auto at = std::min(kParts - 1, static_cast<std::size_t>((p.d - profile.band_from) / width));
      Part& part = strips[std::lround(p.t / kStrip)][at];
      part.sum += off, part.squares += off * off, part.count += 1.0;
    }
    for (const auto& [place, parts] : strips) {
      for (std::size_t j = 0; j < kParts; ++j) {
        products[0] += parts[j].sum * parts[j].sum - parts[j].squares;
        pairs[0] += parts[j].count * (parts[j].count - 1.0);
        for (std::size_t k = j + 1; k < kParts; ++k) {
          products[k - j] += parts[j].sum * parts[k].sum;
          pairs[k - j] += parts[j].count * parts[k].count;
        }
      }
    }
  }
};

/// What points so far apart share of a process of unit variance and a length, on the average over a part's width.
Lags sharedAcross(double length, double width) {
  Lags shared{};
  shared[0] = sharedAlong(width, length);
  const double wide = length * length + width * width / 6.0;
  for (std::size_t apart = 1; apart < kParts; ++apart) {
    const double d = static_cast<double>(apart) * width;
    shared[apart] = length / std::sqrt(wide) * portable::exp(-0.5 * d * d / wide);
  }
  return shared;
}

/// The same in a strip, less the mean over band and arc, which a fit takes away.
Lags expectedAcross(double length, double band, double arc) {
  const Lags shared = sharedAcross(length, band / static_cast<double>(kParts));
  Lags of_part{}, expected{};
  double all = 0;
  for (std::size_t j = 0; j < kParts; ++j) {
    for (std::size_t k = 0; k < kParts; ++k) of_part[j] += shared[j < k ? k - j : j - k] / static_cast<double>(kParts);
    all += of_part[j] / static_cast<double>(kParts);
  }
  const double strip = sharedAlong(std::min(kStrip, arc), length), mean = sharedAlong(arc, length);
  for (std::size_t apart = 0; apart < kParts; ++apart) {
    double taken = 0;
    for (std::size_t j = 0; j + apart < kParts; ++j) taken += of_part[j] + of_part[j + apart] - all;
    expected[apart] = strip * shared[apart] - mean * taken / static_cast<double>(kParts - apart);
  }
  return expected;
}

}  // namespace

Roughness patchesOf(const std::vector<FittedPoints>& fits, const FootProfile& profile, double arc) {
  constexpr std::size_t kFewest = 40;                               // points of a fit
  constexpr double kShortest = 0.01, kLongest = 0.1, kStep = 1.15;  // a fifth of a strip to a third of the band [m]
  SharedAcross seen;
  for (const FittedPoints& fitted : fits) {
    if (fitted.fit.valid() && fitted.fit.points >= kFewest) seen.add(fitted, profile);
  }
  Roughness best;
  double most = 0.0;  // that is explained of the products' squares
  for (double length = kShortest; length < kLongest; length *= kStep) {
    const Lags expected = expectedAcross(length, profile.band_to - profile.band_from, arc);
    double products = 0, squares = 0;
    for (std::size_t k = 0; k < kParts; ++k) {
      products += seen.products[k] * expected[k];
      squares += seen.pairs[k] * expected[k] * expected[k];
    }
    if (!(products > 0.0) || square(products) / squares <= most) continue;
    most = square(products) / squares;
    best = {std::sqrt(products / squares), length};
  }
  return best;
}

double LevelRoughness::over(double longer) const {
  return length > 0.0 ? variance * sharedAlong(std::max(longer, arc), length) / sharedAlong(arc, length) : 0.0;
}

double LevelRoughness::leftOutBy(const RingProcess& process, std::size_t place, double own) const {
  if (!(length > 0.0)) return 0.0;
  const double alone = square(process.scale * own) + square(process.nugget);
  const double stations = std::max(1.0, alone / square(process.sigma[place]));
  return std::max(0.0, over(stations * arc) - variance * square(process.scale) / stations);
}

LevelRoughness levelRoughness(const Roughness& patches, const FootProfile& profile, double arc, double least) {
  if (!(patches.heights > 0.0)) return {least, 0.0, arc};
  const double band = profile.band_to - profile.band_from;
  const double level = square(patches.heights) * sharedAlong(band, patches.length) * sharedAlong(arc, patches.length);
  return {std::max(least, level), patches.length, arc};
}

}  // namespace tank_datum
