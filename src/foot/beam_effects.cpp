#include "foot/beam_effects.h"

#include <algorithm>

#include "core/portable_math.h"
#include "foot/slanting_beams.h"

namespace tank_datum {
namespace {

/// How wide a beam is that comes to the foot so steeply [m].
double beamWidth(double steepness) {
  constexpr double kExit = 0.005, kDivergence = 0.0003, kEye = 1.7;  // [m], [rad], [m]
  return kExit + kDivergence * kEye / steepness;
}

}  // namespace

double BeamEffects::liftAt(double d) const { return reach(d) ? lift * square(1.0 - d / to) : 0.0; }

std::vector<BeamEffects> findBeamEffects(const std::vector<RayCounts>& windows, double from, double reach,
                                         double noise) {
  constexpr std::size_t kBeside = 2;  // windows, to either side
  constexpr double kNarrow = 0.1;     // of the reach: what is seen of a surface less wide tells no density
  constexpr double kLift = 0.15;      // of a beam, half of what simulated floors show
  const std::size_t count = windows.size();
  std::vector<BeamEffects> found;
  for (std::size_t i = 0; i < count; ++i) {
    RayCounts sum;
    for (std::size_t k = i + count - kBeside; k <= i + count + kBeside; ++k) sum.add(windows[k % count]);
    const double a_metre = sum.wide / std::max(sum.wide_to - from, kNarrow * reach);
    const double steepness = steepnessBy(a_metre, sum.on_shell, reach).value_or(0.0);
    found.emplace_back();
    if (!(steepness > 0.0)) continue;
    const double width = beamWidth(steepness);
    found.back() = {0.5 * width / steepness, kLift * width, noise * steepness};
  }
  return found;
}

}  // namespace tank_datum
