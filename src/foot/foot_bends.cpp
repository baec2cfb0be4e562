#include "foot/foot_bends.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "foot/foot_banks.h"

namespace tank_datum {

std::vector<Bend> findBends(const Foot& foot, const std::vector<double>& levels, const std::vector<double>& sigmas,
                            const RingProcess& process) {
  constexpr double kFar = 2.5, kAlso = 1.5;  // standard deviations
  const std::size_t count = levels.size();
  std::vector<std::size_t> middles;
  std::vector<double> offs;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(levels[i])) continue;
    middles.push_back(i);
    offs.push_back((levels[i] - process.value[i]) /
                   std::hypot(std::hypot(sigmas[i], process.nugget), process.sigma[i]));
  }
  const auto reach =
      std::min(count / 2, static_cast<std::size_t>(process.length / kTwoPi * static_cast<double>(count)));
  std::vector<Bend> bends(count, Bend::None);
  for (std::size_t k = 0; k < middles.size(); ++k) {
    if (std::abs(offs[k]) <= kFar) continue;
    const double after = offs[(k + 1) % offs.size()], before = offs[(k + offs.size() - 1) % offs.size()];
    const auto follows = [&](double other) { return std::abs(other) > kAlso && other * offs[k] > 0.0; };
    const bool down =
        offs[k] < 0.0 && countShell(foot, middles[k], levelAt(foot, process.value[middles[k]], 0.0)).goOn();
    if (!(follows(after) || follows(before) || down)) continue;
    for (std::size_t away = 0; away <= reach; ++away) {
      for (const std::size_t i : {(middles[k] + away) % count, (middles[k] + count - away) % count})
        bends[i] = std::max(bends[i], down ? Bend::Seen : Bend::Likely);
    }
  }
  return bends;
}

FootFit bentFit(const FootFit& own, const RingProcess& process, std::size_t station, double shared, Bend bend) {
  FootFit fit = own;
  fit.sigma = std::hypot(std::hypot(own.sigma, process.nugget), shared);
  if (bend == Bend::Seen) return fit;
  fit.sigma = std::hypot(fit.sigma, kEither * (own.z - process.value[station]));
  fit.sigma = std::max(fit.sigma, process.sigma[station]);
  return fit;
}

}  // namespace tank_datum
