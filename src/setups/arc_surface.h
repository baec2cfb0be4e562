#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "setups/arc_comparison.h"

namespace tank_datum {

/// The points of the bins that two setups or more have, by bin.
struct ArcBin {
  std::vector<ArcPoint> points;  ///< setup: the index among those of the arc
  double height = 0.0;           ///< of the surface [m]
  double noise = 0.0;            ///< of the points about it [m]
};

/// What is taken for an arc's surface.
struct ArcSurface {
  static constexpr Eigen::Index kOfPart = 3;  ///< unknowns of a part's curve

  std::vector<std::size_t> setups;
  std::vector<ArcBin> bins;
  Eigen::VectorXd offsets;
  Eigen::VectorXd curves;  ///< of each part its slope, its bend, and what it lies off the others

  double residual(const ArcBin& bin, const ArcPoint& p) const {
    const auto curve = curves.segment<kOfPart>(kOfPart * p.part);
    return p.value - bin.height - offsets[p.setup] - (curve[0] + curve[1] * p.t) * p.t - curve[2];
  }
};

/// Sorts the points of an arc into bins, and guesses its surface by medians, without its slopes and bends. What lies
/// off a bin's densest place, bins that one setup has to itself, and setups with few points are left out.
ArcSurface guessedSurface(const std::vector<ArcPoint>& points, const ArcPrior& prior);

}  // namespace tank_datum
