#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum::rates {

/// Simulated pairs of surveys of one 60 m tank.
struct MovementTrial {
  int runs = 2000;
  int stations = 360;
  double sigma = 0.00026;       ///< of a station [m]
  double scatter = 1.0;         ///< actual errors over sigma
  double window_deg = 2.0;      ///< what the surveys say of the arc behind a station
  double correlated_deg = 0;    ///< arc within which errors are shared; 0: as the surveys say
  bool levelled = false;        ///< their errors are as people state them
  std::string remove = "none";  ///< what is taken from the movement first
  double dip = 0.002;           ///< depth of the dip in the second survey [m]
  double dip_width_deg = 10;    ///< whole
  MovementOptions options;
};

struct MovementRates {
  int runs = 0, alarms = 0;  ///< unmoved pairs, and those with any significant station
  int means = 0, tilts = 0;  ///< unmoved pairs with a significant mean settlement, or change of tilt
  int rests = 0;             ///< unmoved pairs with a significant movement out of plane
  int moved = 0;             ///< unmoved pairs with any of these
  int found = 0;             ///< pairs with a significant station within the dip
  int elsewhere = 0;         ///< of the found: with one further than the dip's width from its middle
};

/// Declares the command `movement` and its options; `trial` must outlive the parsing.
CLI::App* addMovement(CLI::App& app, MovementTrial& trial);

/// Errors of stations 1, 2 and 3 degrees apart are correlated by 0.47, 0.11 and 0.01, as between datums of repeated
/// scans of one tank, or by the overlap of their windows where those are wider than 3 degrees.
MovementRates ratesOf(const MovementTrial& trial);

/// A table on stdout.
void print(const MovementTrial& trial, const MovementRates& rates);

}  // namespace tank_datum::rates
