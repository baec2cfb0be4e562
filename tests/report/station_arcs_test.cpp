#include "report/station_arcs.h"

#include <gtest/gtest.h>

#include "core/units.h"

namespace tank_datum::station_arcs_test {

/// Stations ten degrees apart, of which some lie on another surface.
std::vector<Station> stationsOn(const std::vector<int>& other) {
  std::vector<Station> stations(36);
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i].azimuth = toRadians(10.0 * static_cast<double>(i));
  for (const int i : other) stations[static_cast<std::size_t>(i)].reason = Unmeasured::OtherSurface;
  stations[3].reason = Unmeasured::Hidden;
  return stations;
}

nlohmann::ordered_json jsonOf(const std::vector<Station>& stations) {
  return arcsJson(withReason(stations, Unmeasured::OtherSurface), stations);
}

std::string textOf(const std::vector<Station>& stations) {
  return arcsText(withReason(stations, Unmeasured::OtherSurface), stations, 3);
}

TEST(StationArcs, AreToldByTheirFirstAndLastStation) {
  const auto stations = stationsOn({5, 6, 7, 35, 0, 1});
  EXPECT_EQ(jsonOf(stations).dump(), "[[50.0,70.0],[350.0,10.0]]");
  EXPECT_EQ(textOf(stations), "50 to 70, 350 to 10 deg");
}

TEST(StationArcs, WithoutAnyThereIsNothingToSay) {
  EXPECT_EQ(jsonOf(stationsOn({})).dump(), "[]");
  EXPECT_EQ(textOf(stationsOn({})), "");
  EXPECT_EQ(jsonOf({}).dump(), "[]");
  EXPECT_EQ(textOf({}), "");
}

TEST(StationArcs, OfManyTheFiveLongestAreNamedAndNoneOfTwoStations) {
  const auto stations = stationsOn(
      {0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 13, 14, 15, 16, 18, 19, 20, 21, 23, 24, 25, 26, 28, 29, 30, 31, 33, 34});
  EXPECT_EQ(textOf(stations), "80 to 110, 130 to 160, 180 to 210, 230 to 260, 280 to 310 deg and 2 shorter arcs");
  EXPECT_EQ(jsonOf(stations).size(), 8U);
}

TEST(StationArcs, AWholeRingIsAllOfIt) {
  std::vector<Station> stations = stationsOn({});
  for (Station& s : stations) s.reason = Unmeasured::OtherSurface;
  EXPECT_EQ(jsonOf(stations).dump(), "[[0.0,360.0]]");
}

}  // namespace tank_datum::station_arcs_test
