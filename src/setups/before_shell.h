#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "setups/setup_ring.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Arcs in which a setup sees something that stands before the shell, such as the gussets of anchor chairs, where it
/// is taken to see the shell: it stands out of what the same setup sees up to four arcs beside by more than a shell
/// bends, and by as much more than another setup sees there. A lobe of the shell stands out alike for all.
class BeforeShell {
 public:
  /// The radius of a point if it may be one of the shell, else NaN [m].
  using RadiusOf = std::function<double(const SetupRing::Entry&)>;

  /// @param reach  of the ring [m]
  BeforeShell(const SetupRing& ring, const Tank& tank, double reach, const RadiusOf& radius_of, int threads);

  bool holds(const SetupRing::Entry& point) const;

 private:
  using OfArcs = std::array<bool, SetupRing::kArcs>;
  std::vector<OfArcs> before_;  ///< by setup
};

}  // namespace tank_datum
