#include "foot/foot_bends.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/shell_below.h"

namespace tank_datum {

std::vector<Bend> findBends(const Foot& foot, const std::vector<double>& levels, const std::vector<double>& sigmas,
                            const RingProcess& process) {
  constexpr double kFar = 2.5, kAlso = 1.5;  // standard deviations
  constexpr double kAlone = 4.0;             // of a level that no neighbour follows; the process allows for such
  const std::size_t count = levels.size();
  std::vector<std::size_t> middles;
  std::vector<double> offs;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(levels[i])) continue;
    middles.push_back(i);
    offs.push_back((levels[i] - process.value[i]) /
                   std::hypot(std::hypot(sigmas[i], process.nugget), process.sigmaOfFollowed(i)));
  }
  const auto reach =
      std::min(count / 2, static_cast<std::size_t>(process.length / kTwoPi * static_cast<double>(count)));
  std::vector<Bend> bends(count, Bend::None);
  for (std::size_t k = 0; k < middles.size(); ++k) {
    if (std::abs(offs[k]) <= kFar) continue;
    const std::size_t here = middles[k], next = (k + 1) % offs.size(), last = (k + offs.size() - 1) % offs.size();
    const auto follows = [&](double other) { return std::abs(other) > kAlso && other * offs[k] > 0.0; };
    const bool down = offs[k] < 0.0 && countShell(foot, here, levelAt(foot, process.value[here], 0.0)).goOn();
    const bool alone = !(follows(offs[next]) || follows(offs[last]) || down);
    if (alone && std::abs(offs[k]) <= kAlone) continue;
    // the levels beside one that stands alone lie on the process
    const std::size_t behind = alone ? (here + count - middles[last] - 1) % count : reach;
    const std::size_t ahead = alone ? (middles[next] + count - here - 1) % count : reach;
    for (std::size_t i = here + count - behind; i <= here + count + ahead; ++i)
      bends[i % count] = std::max(bends[i % count], down ? Bend::Seen : Bend::Likely);
  }
  return bends;
}

RingProcess withRisesDoubted(RingProcess process) {
  for (std::size_t i = 0; i < process.bent.size(); ++i) {
    const double rise = std::max(0.0, process.bent[i]);
    process.value[i] -= 0.5 * rise;
    process.sigma[i] = std::hypot(process.sigma[i], kEither * rise);
  }
  return process;
}

FootFit bentFit(const FootFit& own, const RingProcess& process, std::size_t station, double shared, Bend bend) {
  FootFit fit = own;
  fit.sigma = std::hypot(std::hypot(own.sigma, process.nugget), shared);
  if (bend == Bend::Seen) return fit;
  fit.sigma = std::hypot(fit.sigma, kEither * (own.z - process.value[station]));
  fit.sigma = std::max(fit.sigma, process.sigma[station]);
  return fit;
}

double disagreement(const FootFit& window, const RingProcess& process, std::size_t station) {
  if (process.holds(window.z, window.sigma, station)) return 0.0;
  return kEither * std::abs(window.z - process.value[station]);
}

}  // namespace tank_datum
