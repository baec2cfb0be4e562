#pragma once

#include <Eigen/Core>
#include <vector>

#include "movement/epoch_matching.h"

namespace tank_datum {

/// What all stations share of the errors, 1 sigma.
struct CommonErrors {
  double height = 0.0;   ///< left after the removal [m]
  double rim = 0.0;      ///< height at the shell by a tilt about either level axis, left after the removal [m]
  double turn = 0.0;     ///< of the azimuth offset [rad]
  double freedom = 0.0;  ///< degrees of freedom of the scale of the stations' sigmas; 0: it is known
};

/// Leaves no station by itself (a Hampel filter): one that is further from the median of the stations within 2 degrees
/// than two and a half of its sigmas is put there. A shell carries no step over one degree, but scans have single
/// stations seven sigmas off. Stations with fewer than four such neighbours stay as they are.
class Steadied {
 public:
  explicit Steadied(const std::vector<MatchedStation>& stations);

  /// The stations' dz so treated [m].
  Eigen::VectorXd of(const Eigen::VectorXd& dz) const;

 private:
  std::vector<std::vector<Eigen::Index>> beside_;
  std::vector<double> reach_;  ///< of a station's own, in sigmas [m]
};

/// 2000 comparisons of an unmoved tank that lose by the same fits what the differences lost.
struct UnmovedDraws {
  std::vector<double> largest_rest;  ///< out of plane: of each draw, in standard errors
  std::vector<float> dz;             ///< after the removal, a row per draw [m]
};

/// @param stations     before anything is removed
/// @param rest         without a plane
/// @param left         after the removal
/// @param correlation  arc within which stations share points; 0: their windows [rad]
UnmovedDraws drawUnmoved(const std::vector<MatchedStation>& stations, const Removed& rest, const Removed& left,
                         const CommonErrors& common, double correlation);

/// Standard errors of dz, the azimuth offset's part of them included [m].
/// @param turn  1 sigma of the azimuth offset [rad]
std::vector<double> sigmasOf(const std::vector<MatchedStation>& stations, double turn);

/// The largest dz in its standard errors.
double largestOf(const Eigen::VectorXd& dz, const std::vector<double>& sigmas);

}  // namespace tank_datum
