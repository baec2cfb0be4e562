#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace tank_datum {

/// One value that a setup measured in an arc: an elevation of the foundation, or a radius of the shell.
struct ArcPoint {
  double t;                ///< arc from the middle of its part [m]
  double value;            ///< [m]
  std::uint16_t bin;       ///< where across the arc: points of one bin of a part lie on one curve along t
  std::uint16_t setup;     ///< of the scan
  std::uint16_t part = 0;  ///< of a wide arc, along it
};

/// How the setups that see an arc differ there.
struct ArcOffsets {
  std::vector<std::size_t> setups;  ///< of the scan, at least two, rising
  Eigen::VectorXd offsets;          ///< of each setup's values against the arc's common surface, their sum 0 [m]
  Eigen::MatrixXd information;      ///< inverse covariance of the offsets [1/m2]; its rows sum to 0
};

/// What is known of an arc's surface before its points are looked at.
struct ArcPrior {
  double sigma_along;       ///< of its slope along a part [m/m]
  double sigma_bend;        ///< of its second-order term there [1/m]
  double window;            ///< values further than this from a bin's densest place are something else [m]
  std::size_t parts = 1;    ///< that the arc has
  double sigma_part = 1.0;  ///< of what a part lies off the others [m]
};

/// Robust least squares of one height per bin, one slope and bend along each part of the arc, what each lies off the
/// others, and one offset per setup; points are weighted by the scatter of their bin (Tukey's biweight). Everything but
/// the offsets is eliminated: what no two setups see in one part says nothing of them.
/// @return nothing where fewer than two setups are left with points enough
std::optional<ArcOffsets> compareArc(const std::vector<ArcPoint>& points, const ArcPrior& prior);

}  // namespace tank_datum
