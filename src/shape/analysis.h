#pragma once

#include <vector>

#include "limits/survey_spacing.h"
#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// Stations with what else is known of their tank.
struct SurveyedRing {
  const std::vector<Station>& stations;  ///< their u is known
  const Tilt& tilt;
  double radius = 0.0;                 ///< [m]
  std::vector<Measure> shell = {};     ///< figures of the shell, where it was surveyed
  StationCovariance covariance = {};   ///< of the stations; empty: sigma_z each
  double widest_gap = kSurveySpacing;  ///< arc without elevations round which a rule on the shape can pass [m]
  double sigma_radius = 0.0;           ///< [m]
};

/// Describes and judges a ring.
Analysis analyse(const SurveyedRing& ring, const AnalysisOptions& options);

}  // namespace tank_datum
