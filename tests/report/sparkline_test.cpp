#include "report/sparkline.h"

#include <gtest/gtest.h>

#include "tank_datum/core/unknown.h"

namespace tank_datum::sparkline_test {

std::vector<Station> at(const std::vector<double>& elevations) {
  std::vector<Station> stations(elevations.size());
  for (std::size_t i = 0; i < elevations.size(); ++i) stations[i].z = elevations[i];
  return stations;
}

TEST(Sparkline, RisesFromTheLowestToTheHighest) {
  EXPECT_EQ(sparkline(at({0, 1, 2, 3, 4, 5, 6, 7}), 8), "▁▂▃▄▅▆▇█");
  EXPECT_EQ(sparkline(at({7, 6, 5, 4, 3, 2, 1, 0}), 8), "█▇▆▅▄▃▂▁");
}

TEST(Sparkline, AveragesTheStationsOfAColumn) {
  EXPECT_EQ(sparkline(at({0, 2, 6, 8}), 2), "▁█");
  EXPECT_EQ(sparkline(at({0, 4, 1, 3, 5, 5}), 3), "▁▁█");
}

TEST(Sparkline, IsNoWiderThanThereAreStations) { EXPECT_EQ(sparkline(at({0, 1}), 60), "▁█"); }

TEST(Sparkline, IsBlankWhereNothingIsKnown) {
  const double unknown = kUnknown;
  EXPECT_EQ(sparkline(at({0, unknown, 1}), 3), "▁ █");
  EXPECT_EQ(sparkline(at({0, unknown, unknown, 1}), 2), "▁█");  // half a column known
  EXPECT_EQ(sparkline(at({unknown, unknown}), 2), "  ");
  EXPECT_EQ(sparkline({}, 10), "");
}

TEST(Sparkline, OfALevelDatumIsALine) { EXPECT_EQ(sparkline(at({3, 3, 3}), 3), "▅▅▅"); }

}  // namespace tank_datum::sparkline_test
