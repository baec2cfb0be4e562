#include "setups/setup_verdicts.h"

#include <cmath>
#include <cstddef>

#include "locate/keep_points.h"
#include "setups/setup_ring.h"

namespace tank_datum {

SetupVerdict verdictOf(const Setup& setup, bool bad, bool overlaps) {
  constexpr double kPlainly = 3.0;  // sigmas
  if (setup.points == 0) return SetupVerdict::Unseen;
  if (!overlaps) return SetupVerdict::Alone;
  if (bad) return SetupVerdict::Bad;
  const SetupMotion::Vector moved = setup.correction.vector(), sigma = setup.sigma.vector();
  for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) {
    if (std::abs(moved[i]) > kPlainly * sigma[i]) return SetupVerdict::Adjusted;
  }
  return SetupVerdict::Agrees;
}

void markDuplicates(std::vector<Setup>& setups, const RepeatedPoints& repeated) {
  constexpr double kAllOfIt = 0.9;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (repeated.of_setups[s] >= kAllOfIt) setups[s].verdict = SetupVerdict::Duplicate;
  }
}

void dropBad(Ring& ring, const std::vector<Setup>& setups, const Eigen::Vector2d& center) {
  constexpr std::size_t kEnough = 100;  // points of an arc
  const auto is_bad = [&](std::size_t i) { return setups[ring.setupOf(i)].verdict == SetupVerdict::Bad; };
  std::vector<std::size_t> good(SetupRing::kArcs, 0);
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    if (!is_bad(i)) ++good[SetupRing::arcOf(ring.points[i], center)];
  }
  keepPoints(ring,
             [&](std::size_t i) { return !is_bad(i) || good[SetupRing::arcOf(ring.points[i], center)] < kEnough; });
}

}  // namespace tank_datum
