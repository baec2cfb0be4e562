#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// The ring's points round the tank's axis, in cells of azimuth, with their setups and the shell's first outline.
class SetupRing {
 public:
  static constexpr std::size_t kCells = 1440;
  static constexpr std::size_t kArcs = 144;  ///< arcs of ten cells, in which setups are compared

  /// Arcs of a shell that one setup sees from outside at most, never half of it: shells are not round, their centres
  /// not known.
  static constexpr std::size_t kMostOfOneSetup = kArcs / 2 + 4;

  struct Entry {
    double azimuth, radius, z;  ///< [rad], [m], [m]
    std::uint16_t setup;
  };

  SetupRing(const Ring& ring, const Tank& tank, int threads);

  /// The arc that a point about this centre lies in.
  static std::size_t arcOf(const Eigen::Vector3d& point, const Eigen::Vector2d& center);

  /// Over how many arcs those reach that are seen, with those between them.
  template <typename IsSeen>
  static std::size_t spanOf(const IsSeen& is_seen) {
    std::size_t gap = 0, widest = 0;
    for (std::size_t i = 0; i < 2 * kArcs; ++i) {
      gap = is_seen(i % kArcs) ? 0 : gap + 1;
      widest = std::max(widest, gap);
    }
    return kArcs - std::min(widest, kArcs);
  }

  /// The entries of the cells first ... first + count - 1.
  const Entry* begin(std::size_t first) const { return entries_.data() + starts_[first]; }
  const Entry* end(std::size_t last) const { return entries_.data() + starts_[last + 1]; }

  /// The shell's radius here, where it is densest, all setups together [m]; NaN where none is within three cells.
  double outlineAt(double azimuth) const;

 private:
  void sortIntoCells(const Ring& ring, const Eigen::Vector2d& center, int threads);
  void findOutline(const Tank& tank, double reach, int threads);

  std::vector<Entry> entries_;
  std::vector<std::size_t> starts_;
  std::vector<double> outline_;  ///< per cell [m]
};

}  // namespace tank_datum
