#pragma once

#include <vector>

#include "movement/epoch_matching.h"

namespace tank_datum {

/// What the differences of two surveys show of their errors.
struct MovementErrors {
  double scale = 1.0;          ///< errors over the given sigmas, at least 1
  double shown = 1.0;          ///< the same as the stations show it, above or below 1
  double shared = 0.0;         ///< arc within which neighbours share errors; 0: not beyond what the surveys say [rad]
  double freedom = 0.0;        ///< degrees of freedom that the scale is known by; 0: the given sigmas stand
  double freedom_whole = 0.0;  ///< those of settlement and tilt of the whole, which scale and arc both carry; 0: none
};

/// Scatter and autocorrelation of dz about a robust plane, by biweight, medians and pairs of stations (RingPairs): a
/// movement of less than half of the ring hardly changes them, nor does a long wave of the whole ring that stands far
/// above the waves shorter than it. Fewer than 16 stations must scatter by a quarter more than their sigmas; the waves
/// need 11, the autocorrelation 32. What stations scatter beyond four times their sigmas is movement, not error,
/// but for what neighbours share by their windows alone.
MovementErrors shownErrors(const std::vector<MatchedStation>& stations);

/// Gives the stations the larger of given and shown errors of their own, and the wider of the arcs.
/// @param declared  the user's own arc, which stands; 0: none [rad]
void widenErrors(std::vector<MatchedStation>& stations, const MovementErrors& errors, double declared);

/// Settlement and tilt of the whole between two surveys: least squares, before anything is removed.
struct CommonMotion {
  double mean = 0.0, sigma_mean = 0.0;            ///< [m]
  Eigen::Vector2d rim = Eigen::Vector2d::Zero();  ///< height at the shell along x and y by a change of tilt [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// @param height, rim  1 sigma of height and tilt that the registration leaves [m]
CommonMotion commonMotion(const std::vector<MatchedStation>& stations, double height, double rim);

/// How likely an unmoved tank shows as large a change of tilt: the F test on 2 and `freedom` degrees of freedom, or
/// chi-square on 2 where freedom is 0.
double tiltPValue(const CommonMotion& motion, double freedom);

}  // namespace tank_datum
