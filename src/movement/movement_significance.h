#pragma once

#include <vector>

#include "movement/epoch_matching.h"
#include "movement/unmoved.h"

namespace tank_datum {

/// Of each of the four tests of a comparison: mean, tilt, out of plane, stations. By any of them at most 5 % of unmoved
/// tanks are said to have moved (Bonferroni).
constexpr double kAlarmsPerTest = 0.05 / 4.0;
constexpr double kNormalPerTest = 2.497705474412374;  ///< two-sided point of the normal distribution for that

/// Which stations moved, and the threshold that says so.
struct Significance {
  double threshold = 0.0;      ///< of |window mean| in its standard deviations
  std::vector<bool> moved;     ///< one per matched station
  std::vector<double> sigmas;  ///< standard error of each dz [m]
};

/// The largest movement that is left without that of the tank as a rigid body.
struct LargestRest {
  std::size_t station = 0;  ///< its index among those given
  double dz = 0.0;          ///< [m]
  double sigma = 0.0;       ///< standard error of that [m]
  double threshold = 0.0;   ///< of |dz| in its standard errors: beyond it is the largest of few unmoved tanks
  bool moved = false;       ///< beyond that, and not a single station that stands out from its neighbours
};

/// @param stations  by direction, a plane taken from dz and from what they share of their errors
/// @param drawn     the largest of each draw of an unmoved tank, in standard errors
/// @param turn      1 sigma of the azimuth offset [rad]
LargestRest largestRest(const std::vector<MatchedStation>& stations, const std::vector<double>& drawn, double turn);

/// A multi-scale scan: means of dz over windows of one station to 48 degrees about every station, each in units of its
/// standard deviation on an unmoved tank. The threshold is beyond the largest of them all in all but kAlarmsPerTest of
/// 2000 simulated comparisons with the stations' own sigmas, the correlation of stations that share points, the common
/// errors and the removal: a max-statistic (Westfall and Young,
/// Resampling-based multiple testing, 1993) over a scan of windows (Naus, JASA 60, 1965).
/// Windows are judged from narrow to wide. One counts when it has moved without the stations found before too, or when
/// such stations lie on either side of its middle, so that a movement does not spread over the wide windows it is in.
/// Single stations that stand out from their neighbours by themselves are taken for errors and not for movement, in the
/// simulated comparisons as well (Hampel, JASA 69, 1974).
/// @param stations  by direction, dz after the removal
/// @param draws     of an unmoved tank, dz after the removal, a row per draw [m]
Significance findMoved(const std::vector<MatchedStation>& stations, const std::vector<float>& draws,
                       const CommonErrors& common);

}  // namespace tank_datum
