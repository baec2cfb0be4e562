#include "shape/levelness.h"

#include "shape/level_rows.h"

namespace tank_datum {

PlacedValue steepest(const std::vector<Station>& stations, double radius, double arc, double Station::*quantity) {
  const RingSeries series(stations, quantity, &Station::sigma_z);
  return slopeRows(series, radius, arc).largestOf(series.values());
}

PlacedValue unevennessWithin(const std::vector<Station>& stations, double radius, double arc) {
  const RingSeries series(stations, &Station::z, &Station::sigma_z);
  return LevelWithin(series, radius, arc).largest(series.values());
}

PlacedValue unevennessOfAll(const std::vector<Station>& stations) {
  const RingSeries series(stations, &Station::z, &Station::sigma_z);
  return MeanLevel(series, stations).furthest(series.values());
}

}  // namespace tank_datum
