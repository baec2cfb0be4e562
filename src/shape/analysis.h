#pragma once

#include <vector>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// Describes and judges stations whose u is known.
/// @param radius  of the tank [m]
/// @param shell       figures of the shell, where it was surveyed
/// @param covariance  of the stations; empty: sigma_z each
Analysis analyse(const std::vector<Station>& measured, const Tilt& tilt, double radius, const AnalysisOptions& options,
                 const std::vector<Measure>& shell = {}, const StationCovariance& covariance = {});

}  // namespace tank_datum
