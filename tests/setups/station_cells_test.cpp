#include "setups/station_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "stations/stations.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::station_cells_test {

TEST(StationCells, ThereAreAtLeast360AndAWholeNumberToAStation) {
  StationOptions options;
  for (const int stations : {8, 7, 360, 361, 720}) {
    options.count = stations;
    const std::size_t cells = StationCells(emptyStations(options)).count();
    EXPECT_GE(cells, 360U);
    EXPECT_EQ(cells % static_cast<std::size_t>(stations), 0U);
    EXPECT_LT(cells, 360U + static_cast<std::size_t>(stations));
  }
}

TEST(StationCells, ACellHasTheLevelOfTheNearestKnownStation) {
  StationOptions options;
  options.count = 36;
  std::vector<Station> stations = emptyStations(options);
  for (Station& s : stations) s.z = s.radius = kUnknown;
  stations[3].z = 0.1, stations[3].radius = 10.0;
  stations[6].z = 0.2, stations[6].radius = 11.0;
  const StationCells cells(stations);
  const auto z_at = [&](double degrees) {
    return cells.level(cells.cellOf(stations[0].direction + toRadians(degrees))).z;
  };
  EXPECT_EQ(z_at(30.0), 0.1);
  EXPECT_EQ(z_at(44.0), 0.1);
  EXPECT_EQ(z_at(46.0), 0.2);
  EXPECT_EQ(z_at(200.0), 0.2);
  EXPECT_EQ(z_at(260.0), 0.1);
}

}  // namespace tank_datum::station_cells_test
