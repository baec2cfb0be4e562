#include "foot/blurred_lips.h"

#include <algorithm>
#include <cmath>

#include "core/statistics.h"

namespace tank_datum {
namespace {

/// Whether noise is as wide as lips.
bool isBlurred(const ShellStrip& strip, double reach) {
  constexpr double kNarrowest = 0.03;  // lips, of the reach: 15 mm
  return strip.from >= kNarrowest * reach;
}

/// What is seen nearest to the shell.
std::vector<double> heightsNearest(const ShellStrip& strip, double reach) {
  constexpr double kNearest = 1.0 / 3.0;  // of the strip
  std::vector<double> heights;
  for (const Beside& p : strip.points) {
    if (p.d < strip.from + kNearest * (strip.to - strip.from) && std::abs(p.height) < kHighestLip * reach)
      heights.push_back(p.height);
  }
  return heights;
}

BlurredRise riseOf(const std::vector<double>& heights) {
  if (heights.empty()) return {};
  const double height = median(heights);
  return {height, kMedianOverMean * robustSigma(heights, height) / std::sqrt(static_cast<double>(heights.size()))};
}

}  // namespace

BlurredRise blurredRise(const std::vector<ShellStrip>& strips, double reach) {
  std::vector<double> all;
  for (const ShellStrip& strip : strips) {
    if (!isBlurred(strip, reach)) continue;
    const std::vector<double> heights = heightsNearest(strip, reach);
    all.insert(all.end(), heights.begin(), heights.end());
  }
  return riseOf(all);
}

double blurredLip(const ShellStrip& strip, const BlurredRise& round_the_ring, double reach) {
  constexpr double kUsual = 0.1;       // lips, of the reach: 50 mm
  constexpr double kThickness = 0.02;  // of the reach: 10 mm
  if (!strip.valid() || !isBlurred(strip, reach)) return 0.0;
  const double hidden = strip.from < kUsual * reach ? 0.0 : kThickness * reach;
  const BlurredRise here = riseOf(heightsNearest(strip, reach));
  const BlurredRise& rise = here.isSure() ? here : round_the_ring;
  return rise.isSure() ? std::max(hidden, 2.0 * rise.height) : hidden;
}

}  // namespace tank_datum
