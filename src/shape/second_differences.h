#pragma once

#include <string>
#include <vector>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

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

/// Of the survey that planSurvey gives.
/// @param radius  of the tank [m]
SecondDifferences secondDifferencesOf(const std::vector<Station>& stations, double radius, int points);

}  // namespace tank_datum
