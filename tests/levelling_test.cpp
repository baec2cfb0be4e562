#include "levelling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"
#include "tank_datum/report/report.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::levelling_test {

std::string refusal(const std::string& text) {
  return refusalOf(Error::Kind::Option, [&] { levellingStations(text, "l.csv", 1.0, 10.0, {}); });
}

TEST(LevellingStations, ReadsSortsAndScales) {
  const auto stations = levellingStations("elevation,azimuth_deg,sigma,who\n20,90,1,a\n10,-90,,b\n,0,,c\n+30,180,2,d\n",
                                          "l", 0.001, 10, {});
  ASSERT_EQ(stations.size(), 4U);
  EXPECT_EQ(stations[0].flag, StationFlag::Missing);
  EXPECT_TRUE(std::isnan(stations[0].z) && std::isnan(stations[0].radius));
  EXPECT_NEAR(stations[1].azimuth, 90 * kDegree, 1e-12);
  EXPECT_NEAR(stations[1].z, 0.02, 1e-15);
  EXPECT_NEAR(stations[1].sigma_z, 0.001, 1e-15);
  EXPECT_NEAR(stations[1].y, 5.0, 1e-12);
  EXPECT_NEAR(stations[2].z, 0.03, 1e-15);
  EXPECT_NEAR(stations[3].azimuth, 270 * kDegree, 1e-12);
  EXPECT_TRUE(std::isnan(stations[3].sigma_z));
}

TEST(LevellingStations, AzimuthsCountAsTheUserSays) {
  StationOptions north;
  north.zero_azimuth = 90 * kDegree;
  north.clockwise = true;
  const auto stations = levellingStations("azimuth_deg,elevation\n90,1\n", "l", 1.0, 10.0, north);
  EXPECT_NEAR(stations[0].x, 5.0, 1e-12);  // east
  EXPECT_NEAR(stations[0].y, 0.0, 1e-12);
}

TEST(LevellingStations, RefusesWithFileAndLine) {
  EXPECT_EQ(refusal("azimuth_deg,elevation\n0,1\n10,x\n"),
            "levelling: l.csv line 3 elevation, \"x\", expected a number");
  EXPECT_NE(refusal("azimuth_deg,elevation\n0,1,2\n").find("line 2, 3 cells"), std::string::npos);
  EXPECT_NE(refusal("azimuth_deg,elevation\nnan,1\n").find("azimuth_deg, \"nan\""), std::string::npos);
  EXPECT_NE(refusal("azimuth_deg,elevation,sigma\n0,1,0\n").find("sigma, 0, expected > 0"), std::string::npos);
  EXPECT_EQ(refusal("azimuth_deg;elevation\n0;1\n"),
            "levelling: l.csv line 1, \"azimuth_deg;elevation\", expected the header azimuth_deg,elevation or "
            "azimuth_deg,elevation,sigma");
  EXPECT_NE(refusal("azimuth_deg,elevation\n0,1,5\n").find("decimal points"), std::string::npos);
  EXPECT_NE(refusal("azimuth_deg,elevation\n366,1\n").find("azimuth_deg, 366, expected degrees, -360 to 360"),
            std::string::npos);
  EXPECT_NE(refusal("").find("no lines"), std::string::npos);
  EXPECT_NE(refusal("azimuth_deg,elevation\n0,1\n360,2\n").find("two rows at 0.0"), std::string::npos);
}

/// The work grows with the square of the rows: 200 000 took most of a minute, in gigabytes.
TEST(LevellingStations, AreAtMostTenADegree) {
  const auto table = [](int rows) {
    std::string text = "azimuth_deg,elevation\n";
    for (int i = 0; i < rows; ++i) text += std::to_string(i * 0.09) + ",1\n";
    return text;
  };
  EXPECT_EQ(refusal(table(3600)), "");
  EXPECT_EQ(refusal(table(3601)), "levelling: l.csv, 3601 rows, expected at most 3600");
}

TEST(LevellingStations, RowsAreAtOneAzimuthUpToAMillionthOfARadian) {
  const auto rowsApart = [](double radians) {
    return refusal("azimuth_deg,elevation\n0,1\n" + std::to_string(1e6 * radians / kDegree) + "e-6,2\n");
  };
  EXPECT_NE(rowsApart(0.8e-6).find("two rows at 0.0"), std::string::npos);
  EXPECT_EQ(rowsApart(1.25e-6), "");
}

std::vector<Station> ring(std::size_t count) {
  std::string text = "azimuth_deg,elevation\n";
  for (std::size_t i = 0; i < count; ++i) {
    const double a = 360.0 * static_cast<double>(i) / static_cast<double>(count);
    text += std::to_string(a) + "," + std::to_string(2.0 + 0.01 * std::cos(a * kDegree)) + "\n";
  }
  return levellingStations(text, "l", 1.0, 20.0, {});
}

TEST(DatumOfLevelling, ElevationsInAnotherUnitAreRefused) {
  std::vector<Station> stations = ring(16);
  stations[3].z += 1.95;
  EXPECT_NO_THROW(datumOfLevelling(stations, 20.0, {}));
  stations[3].z += 0.1;
  try {
    datumOfLevelling(stations, 20.0, {});
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("are they in option units"), std::string::npos);
  }
}

TEST(DatumOfLevelling, StationsOfAnArcAreProbablyInRadians) {
  const auto within = [](double degrees) {
    std::string text = "azimuth_deg,elevation\n";
    for (int i = 0; i < 12; ++i) text += std::to_string(degrees * i / 11.0) + ",1\n";
    return refusalOf(Error::Kind::Option,
                     [&] { datumOfLevelling(levellingStations(text, "l", 1.0, 20.0, {}), 20.0, {}); });
  };
  EXPECT_EQ(within(6.0),
            "levelling: azimuths, all within 6.0 degrees, expected stations round the tank, in degrees (radians need a "
            "factor of 57.2958)");
  EXPECT_EQ(within(14.0).substr(0, 20), "levelling: azimuths,");
  EXPECT_EQ(within(16.0), "");
}

TEST(DatumOfLevelling, ATankIsNoLargerThanAnyThatStands) {
  const auto stations = levellingStations("azimuth_deg,elevation\n0,1\n90,1\n180,1\n270,1\n", "l", 1.0, 10.0, {});
  EXPECT_TRUE(datumOfLevelling(stations, 1000.0, {}).levelled);
  try {
    datumOfLevelling(stations, 1001.0, {});
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "levelling: diameter, 1001, expected the tank's in metres, > 0 and <= 1000");
  }
}

TEST(DatumOfLevelling, IsDescribedAsThatOfAScan) {
  const Datum datum = datumOfLevelling(ring(16), 20.0, {});
  EXPECT_EQ(datum.status, Status::Ok);
  EXPECT_TRUE(datum.levelled);
  EXPECT_NEAR(datum.level.mean, 2.0, 1e-6);
  EXPECT_NEAR(datum.tilt.slope(), 0.001, 1e-6);
  EXPECT_NEAR(datum.antipodal.max_h, 0.02, 1e-6);
  EXPECT_TRUE(datum.analysis.valid());
  const std::string text = summary(datum);
  EXPECT_NE(text.find("radius 10.000 m as given"), std::string::npos) << text;
  EXPECT_NE(text.find("levelling survey"), std::string::npos) << text;
  EXPECT_EQ(text.find("paper's curve"), std::string::npos) << text;
}

TEST(DatumOfLevelling, NeedsFourElevationsAndADiameter) {
  const Datum few = datumOfLevelling(ring(3), 20.0, {});
  EXPECT_EQ(few.status, Status::TooFewPoints);
  EXPECT_NE(few.message.find("3 stations"), std::string::npos);
  EXPECT_EQ(datumOfLevelling(ring(4), 20.0, {}).status, Status::Ok);
  for (const double diameter : {0.0, -1.0, std::nan("")}) EXPECT_THROW(datumOfLevelling(ring(8), diameter, {}), Error);
}

TEST(DatumOfLevelling, DiametersAreOfStationsThatLieAcross) {
  auto stations = ring(16);
  stations.erase(stations.begin() + 3);
  EXPECT_TRUE(std::isfinite(datumOfLevelling(stations, 20.0, {}).antipodal.max_h));
  for (std::size_t i = 0; i < stations.size(); ++i) stations[i].azimuth += 1e-3 * static_cast<double>(i);
  const Datum datum = datumOfLevelling(stations, 20.0, {});
  EXPECT_TRUE(datum.tilt.valid());
  EXPECT_TRUE(std::isnan(datum.antipodal.max_h));
}

}  // namespace tank_datum::levelling_test
