#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/limits/checks.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/shape/deformation.h"
#include "tank_datum/shape/out_of_plane.h"
#include "tank_datum/shape/second_differences.h"
#include "tank_datum/shape/settlement_arcs.h"
#include "tank_datum/stations/placed_value.h"

namespace TANK_DATUM_API tank_datum {

struct AnalysisOptions {
  TankFacts facts;
  int classic_points = 0;                        ///< survey points for the classic rule; 0: every 20 ft
  std::vector<Limit> limits = standardLimits();  ///< what the figures are judged by
  std::string limits_file;                       ///< where they were read from; empty: they come with the library
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const AnalysisOptions& options);

/// A settlement or a rise of one part of the ring that its waves and its errors do not explain.
struct LocalSettlement {
  double azimuth = kUnknown;  ///< of its middle, as the user counts azimuths [rad]
  double width = kUnknown;    ///< from where it begins to where it ends [rad]
  double height = kUnknown;   ///< in its middle, settlement negative [m]
  double sigma = kUnknown;    ///< [m]
};

/// What the datum's shape means.
struct Analysis {
  std::vector<Harmonic> harmonics;
  OutOfPlane out_of_plane;
  std::vector<LocalSettlement> local_settlements;  ///< of more than 64 stations
  SecondDifferences second_differences;
  std::vector<SettlementArc> arcs;
  PlacedValue level_9m, level_3m, level_total;  ///< of the foundation (API 650 7.5.5) [m]
  double longest_gap = kUnknown;                ///< arc between neighbouring stations with an elevation [m]
  std::vector<Measure> measures;                ///< the figures, as they go to the limits
  std::vector<Check> checks;
  Headline headline;               ///< what the checks come to
  std::vector<std::string> notes;  ///< for every reader of the checks

  bool valid() const { return !checks.empty(); }
};

/// Describes and judges stations whose tilt is fitted; fills u_fit and curvature of those whose z is known.
/// @param radius  of the tank [m]
/// @param shell       figures of the shell, where it was surveyed
/// @param covariance  of the stations; empty: sigma_z each
Analysis analyse(std::vector<Station>& stations, const Tilt& tilt, double radius, const AnalysisOptions& options,
                 const std::vector<Measure>& shell = {}, const StationCovariance& covariance = {});

}  // namespace tank_datum
