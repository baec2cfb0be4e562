#pragma once

#include <Eigen/Core>
#include <vector>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// Highest, lowest, mean: from measured and interpolated stations.
Level levelOf(const std::vector<Station>& stations);

/// The difference of height across every diameter, in the stations' order over half a turn: positive when the first
/// end is the higher one, NaN where an end is not known. None of a station that has no other across from it.
std::vector<double> antipodalHeights(const std::vector<Station>& stations);

/// The largest of them. An upper bound of the tilt: a bump or an error of one station counts in full.
Antipodal antipodalOf(const std::vector<Station>& stations);

/// Linear regression of z on 1, cos, sin (STANDARDS: tilt plane) over the measured stations, about `center`; at least
/// four of them. Of up to 64 stations all round by least squares, weighted by their standard errors; of more, or beside
/// a gap, along with the waves of the datum (RingModel), so that these do not pass for tilt. sigma_slope comes from the
/// errors of the stations, shared ones and those that neighbours show included, and from what waves leave unknown, not
/// from out-of-plane settlement. Beside a gap p_value is of a chi-square test.
/// @param covariance  of the stations; empty: sigma_z each
Tilt fitTilt(const std::vector<Station>& stations, const Eigen::Vector2d& center, const StationOptions& options,
             const StationCovariance& covariance = {});

/// Where the stations whose z is known stand to a plane fitted about `center`; nothing of any without a plane.
std::vector<StationTilt> standingsTo(const Tilt& tilt, const std::vector<Station>& stations,
                                     const Eigen::Vector2d& center);

}  // namespace tank_datum
