#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/placed_value.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// The classic out-of-plane rule of API 653 Annex B: S_i = |U_i - (U_{i-1} + U_{i+1}) / 2|.
struct SecondDifferences {
  int points = 0;                ///< survey points round the tank; 0: the rule does not apply
  int starts = 0;                ///< survey of so many start angles, each with its own points
  double spacing = kUnknown;     ///< arc between points, L [m]
  std::vector<PlacedValue> all;  ///< every S_i of every start
  std::string message;           ///< why there are none, or what limits their use

  bool valid() const { return !all.empty(); }
};

/// Stations further apart than 15 ft are survey points as they are. Of closer ones a survey of `points` is taken, from
/// every station between two points as its start, so that luck in the choice shows; 0 takes the even number nearest to
/// 20 ft. A number whose spacing is not from 15 to 32 ft gets an explanation instead: the limit falls with the square
/// of the spacing, noise does not.
/// @param radius  of the tank [m]
SecondDifferences secondDifferencesOf(const std::vector<Station>& stations, double radius, int points);

}  // namespace tank_datum
