#pragma once

#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/movement/movement.h"

namespace TANK_DATUM_API tank_datum {

/// One place of the datum through all surveys.
struct StationHistory {
  double azimuth = kUnknown;             ///< as the last survey counts it [rad]
  double direction = kUnknown;           ///< in the baseline's frame [rad]
  std::vector<StationMovement> surveys;  ///< its movement at each survey after the baseline; dz NaN where unknown
  double rate = kUnknown;                ///< least-squares slope of the elevation against time [m per unit of time]
  double sigma_rate = kUnknown;          ///< its standard error, from the surveys' own

  bool significant = false;  ///< of all places shown at once: some unmoved one is in at most 5 % of tanks

  double lod95() const { return kNormal95 * sigma_rate; }  ///< 95 % level of detection of the rate, of this place alone
};

/// The movements since one baseline, place by place: at the stations of the last survey that was compared. Other
/// surveys are interpolated between stations at most 2 degrees apart, as in compareEpochs; a place that a survey has
/// not seen has a rate from the others, if two surveys are left.
/// @param movements  in time order, of one baseline
/// @param times      of the baseline and then of each survey, increasing: one more than movements
/// @throws Error (Option) when the times are not that
std::vector<StationHistory> historiesOf(const std::vector<Movement>& movements, const std::vector<double>& times);

/// The time of a date as "2024-05-31" or a decimal year as "2024.41" [years].
/// @throws Error (Option) for anything else, a date that there is not included
double yearOf(const std::string& date);

}  // namespace tank_datum
