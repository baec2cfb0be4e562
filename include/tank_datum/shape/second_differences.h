#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/placed_value.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// The survey points of the rules on neighbours: which stations they are, or how they are chosen among dense ones.
struct SurveyPlan {
  int points = 0;              ///< round the tank; 0: there is no survey, see message
  double spacing = kUnknown;   ///< mean arc between points, L [m]
  bool as_they_are = false;    ///< the stations are the points, equally spaced or not
  std::vector<double> starts;  ///< azimuths of the first point of each survey; one when as_they_are [rad]
  std::string message;         ///< why there is none, or what limits its use

  bool valid() const { return points > 0; }
};

/// Stations 15 ft or more apart on the average are survey points as they are. Of closer ones surveys of `points`
/// equally spaced ones are taken; 0 takes the even number nearest to 20 ft. One survey starts at each station, so that
/// the station furthest out of plane is a point of one, and at least ten different ones are made, so that luck in the
/// choice shows. A number whose spacing is not from 15 to 32 ft gets an explanation instead: the limit falls with the
/// square of the spacing, noise does not.
/// @param radius  of the tank [m]
SurveyPlan planSurvey(const std::vector<Station>& stations, double radius, int points);

/// The classic out-of-plane rule of API 653 Annex B: S_i = |U_i - (U_{i-1} + U_{i+1}) / 2|; between points that are
/// not equally spaced, the distance of U_i from the chord of its neighbours.
struct SecondDifferences {
  int points = 0;                ///< survey points round the tank; 0: the rule does not apply
  int starts = 0;                ///< surveys of so many start angles, each with its own points
  double spacing = kUnknown;     ///< mean arc between points [m]
  std::vector<PlacedValue> all;  ///< every S_i of every start
  std::vector<double> spacings;  ///< L of each: the root of its two arcs' product [m]
  std::size_t worst = 0;         ///< the one largest beside its limit, which goes with L^2
  std::string message;           ///< why there are none, or what limits their use

  bool valid() const { return !all.empty(); }
};

/// Of the survey that planSurvey gives.
/// @param radius  of the tank [m]
SecondDifferences secondDifferencesOf(const std::vector<Station>& stations, double radius, int points);

}  // namespace tank_datum
