#include "foot/rough_arcs.h"

#include <utility>

#include "core/parallel.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/two_levels.h"
#include "foot/foot_heaps.h"
#include "foot/foot_roughness.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kArc = 4.0 * kDegree;  // to either side, that is looked at together

/// Mean of a station's value and those beside it, weighed by their points; NaN where these are few.
double pooledAround(const std::vector<FootFit>& own, const std::vector<double>& values, std::size_t station,
                    std::size_t near) {
  constexpr double kFewest = 15.0;  // points that tell a threefold variance from chance, each in several fits
  double sum = 0, points = 0;
  for (std::size_t k = station + own.size() - near; k <= station + own.size() + near; ++k) {
    const FootFit& fit = own[k % own.size()];
    if (!fit.valid()) continue;
    const auto weight = static_cast<double>(fit.points);
    sum += weight * values[k % own.size()], points += weight;
  }
  return points >= kWithNeighbours * kFewest ? sum / points : kUnknown;
}

/// Variance about two levels of the points that a fit of a station with its neighbours goes through.
double varianceAboutTwo(const Foot& foot, const FootPass& pass, std::size_t station, const FootFit& own) {
  constexpr std::size_t kFewest = 8, kPlenty = 500;
  const FootProfile& profile = pass.sections.at(station);
  std::vector<double> all, offs;
  foot.ring.visitAround(foot.directions[station], kWithNeighbours * foot.half_step, own.z, foot.reach,
                        [&](const FootPoint& p) {
                          const double off = offOf(p, own);
                          if (isOfBand(p, off, own, profile)) all.push_back(off);
                        });
  for (std::size_t i = 0; i < all.size(); i += all.size() / kPlenty + 1) offs.push_back(all[i]);
  return offs.size() < kFewest ? own.own * own.own : square(fitTwoLevels(offs).sigma);
}

}  // namespace

std::vector<bool> findRoughArcs(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& own) {
  constexpr double kRougher = 3.0;  // times the usual variance: no foundation differs by more along the shell
  constexpr double kApart = 0.2;    // of the variance is left about two levels that lie four deviations apart
  const std::size_t count = own.size(), near = foot.stationsBeside(kArc);
  std::vector<double> squares, variances(count), about_two(count);
  for (const FootFit& fit : own) squares.push_back(square(fit.own));
  for (std::size_t i = 0; i < count; ++i) variances[i] = pooledAround(own, squares, i, near);
  const std::vector<double> known = finiteOf(variances);
  std::vector<bool> rough(count, false);
  if (known.empty()) return rough;
  // where rays come down steeply all of their noise is height
  const double most = kRougher * median(known) + square(foot.scales.shell_noise);
  std::vector<char> asked(count, 0);  // whose levels tell of a rough arc
  for (std::size_t i = 0; i < count; ++i) {
    rough[i] = variances[i] > most;
    for (std::size_t k = i + count - near; rough[i] && k <= i + count + near; ++k) asked[k % count] = 1;
  }
  forEachIndex(count, 0, [&](std::size_t i) {
    if (asked[i] && own[i].valid()) about_two[i] = varianceAboutTwo(foot, pass, i, own[i]);
  });
  for (std::size_t i = 0; i < count; ++i) {
    const double left = rough[i] ? pooledAround(own, about_two, i, near) : kUnknown;
    if (left <= most && left < kApart * variances[i]) rough[i] = false;
  }
  return rough;
}

FootPass withoutRoughArcs(const Foot& foot, FootPass pass) {
  const std::vector<bool> rough = findRoughArcs(foot, pass, standing(pass.outliers.own, pass.outliers.reasons));
  for (std::size_t i = 0; i < rough.size(); ++i) {
    if (!rough[i] || !pass.fits[i].valid()) continue;
    pass.outliers.reasons[i] = Unmeasured::OtherSurface;
    pass.outliers.refused[i] = {pass.fits[i].z, kUnknown};
  }
  pass.fits = standing(std::move(pass.fits), pass.outliers.reasons);
  return pass;
}

}  // namespace tank_datum
