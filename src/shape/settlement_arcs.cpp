#include "shape/settlement_arcs.h"

#include <cmath>

#include "shape/arc_points.h"
#include "stations/ring_series.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

std::vector<SettlementArc> settlementArcs(const std::vector<Station>& stations, double radius) {
  const ArcPoints points(stations, radius);
  return points.arcsOf(points.values());
}

}  // namespace tank_datum
