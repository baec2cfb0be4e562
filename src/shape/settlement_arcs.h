#pragma once

#include <vector>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// The arcs between zero crossings of U, half the circumference each where U changes its sign only twice (fold pattern,
/// ballot B.2.2.5.3). Of more than 64 stations those of its regression; without one, those of survey points, each the
/// mean of the stations round it, one of them at the station furthest out of plane (B.2.2.8.1): noise crosses zero too.
/// Empty when U nowhere changes its sign.
std::vector<SettlementArc> settlementArcs(const std::vector<Station>& stations, double radius);

}  // namespace tank_datum
