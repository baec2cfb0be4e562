#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// What may cover a lip and be measured for it.
struct LipCover {
  /// Stations in arcs where what lies farther out is lower below the lip than round the ring, more and more so
  /// outwards: soil covers the lip and what it lies on alike, and ends farther out. (What covers the latter only stands
  /// higher below the lip.)
  std::vector<bool> covered;
  /// How much lower all of it lies than round the ring, where that is plain [m], else 0: soil that covers the lip only
  /// looks so, and a ringwall that sank below a shell that did not.
  std::vector<double> maybe;
};

/// Looks at the sections of arcs against the ring's, which tell more than the slope of the few points on a lip.
/// @param kept  fits of the stations that stand
LipCover findLipCover(const Foot& foot, const FootPass& pass, const std::vector<FootFit>& kept);

}  // namespace tank_datum
