#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/made_datums.h"

namespace tank_datum::datum_json_test {

using Json = nlohmann::ordered_json;
using made_datums::octagon;
using made_datums::provenance;

std::vector<std::string> keysOf(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

Json parsed(const Datum& datum) { return Json::parse(datumJson(datum, provenance())); }

TEST(DatumJson, HasTheContractsKeys) {
  const Json json = parsed(octagon());
  EXPECT_EQ(keysOf(json), (std::vector<std::string>{"schema", "version", "input", "options", "status", "message",
                                                    "service", "tank", "tests", "lean", "datum", "tilt", "antipodal",
                                                    "setups", "agreement", "covariance", "stations"}));
  EXPECT_EQ(json["schema"], 1);
  EXPECT_EQ(json["status"], "partial");
  EXPECT_EQ(json["message"], octagon().message);
  EXPECT_EQ(keysOf(json["tank"]), (std::vector<std::string>{"center", "radius", "sigma_radius", "rms", "coverage_deg",
                                                            "foot_points_per_degree", "side"}));
  EXPECT_EQ(keysOf(json["datum"]),
            (std::vector<std::string>{"surface", "other_surface_deg", "shell_below_deg", "in_doubt_deg", "measured",
                                      "interpolated", "missing", "mean", "min", "max", "range", "min_azimuth_deg",
                                      "max_azimuth_deg", "curve"}));
  EXPECT_EQ(keysOf(json["datum"]["curve"]),
            (std::vector<std::string>{"degree", "closed", "control_points", "rms", "max_residual", "check_points"}));
  EXPECT_EQ(keysOf(json["tilt"]), (std::vector<std::string>{"slope", "angle_arcsec", "direction_deg", "sigma_slope",
                                                            "standard_error", "r2", "p_value"}));
  EXPECT_EQ(keysOf(json["antipodal"]),
            (std::vector<std::string>{"max_h", "diameter", "angle_deg", "angle_arcsec", "azimuth_deg", "h"}));
  EXPECT_EQ(keysOf(json["stations"][0]),
            (std::vector<std::string>{"azimuth_deg", "direction_deg", "z", "sigma_z", "window_deg", "flag", "reason"}));
}

TEST(DatumJson, HoldsEveryStationInTheScansFrame) {
  const Json stations = parsed(octagon())["stations"];
  ASSERT_EQ(stations.size(), 8U);
  EXPECT_NEAR(stations[3]["azimuth_deg"], 135.0, 1e-9);
  EXPECT_NEAR(stations[3]["direction_deg"], 135.0, 1e-9);
  EXPECT_NEAR(stations[3]["z"], 100.628, 1e-9);
  EXPECT_EQ(stations[3]["sigma_z"], 0.00025);
  EXPECT_EQ(stations[5]["flag"], "interpolated");
  EXPECT_TRUE(stations[6]["z"].is_null());
}

TEST(DatumJson, IsInTheScansFrameInMetresAndDegrees) {
  const Json json = parsed(octagon());
  EXPECT_EQ(json["tank"]["center"], Json({500001.5, 4000002.25}));
  EXPECT_EQ(json["tank"]["radius"], 10.0);
  EXPECT_NEAR(json["tank"]["coverage_deg"], 350.0, 1e-9);
  EXPECT_EQ(json["tank"]["side"], "outside");
  EXPECT_EQ(json["datum"]["surface"], "annular_plate");
  EXPECT_EQ(json["datum"]["measured"], 6);
  EXPECT_EQ(json["datum"]["interpolated"], 1);
  EXPECT_EQ(json["datum"]["missing"], 1);
  EXPECT_NEAR(json["datum"]["min"], 100.625, 1e-9);
  EXPECT_NEAR(json["datum"]["max_azimuth_deg"], 315.0, 1e-9);
  EXPECT_NEAR(json["datum"]["range"], 0.007, 1e-12);
  EXPECT_NEAR(json["antipodal"]["diameter"], 20.0, 1e-9);
  Datum inside = octagon();
  inside.tank.side = Side::Inside;
  EXPECT_EQ(parsed(inside)["tank"]["side"], "inside");
}

TEST(DatumJson, WhatIsUnknownIsNull) {
  const Json json = parsed(octagon());
  EXPECT_TRUE(json["datum"]["curve"]["rms"].is_null());
  Datum paper = octagon();
  paper.refined = {};
  paper.tilt = {};
  paper.antipodal = {};
  const Json plain = parsed(paper);
  EXPECT_TRUE(plain["datum"]["surface"].is_null());
  EXPECT_TRUE(plain["tank"]["sigma_radius"].is_null());
  EXPECT_TRUE(plain["tilt"].is_null());
  EXPECT_TRUE(plain["antipodal"]["max_h"].is_null());
}

TEST(DatumJson, OfNoTankHoldsNoNumbersOfOne) {
  Datum none;
  none.status = Status::NoTank;
  const Json json = parsed(none);
  EXPECT_EQ(json["status"], "no_tank");
  EXPECT_TRUE(json["tank"].is_null());
  for (const char* key : {"datum", "tilt", "antipodal", "stations"}) EXPECT_FALSE(json.contains(key)) << key;
}

TEST(DatumJson, SaysWhatWentInAndEveryOption) {
  Provenance from = provenance();
  from.options.method = Method::Paper;
  from.options.tank = Circle{{1, 2}, 3};
  from.options.stations.clockwise = true;
  const Json json = Json::parse(datumJson(octagon(), from));
  const Json hash = {{"algorithm", "sha256"}, {"value", "abc"}};
  EXPECT_EQ(json["input"]["files"][0], (Json{{"path", "a.pcd"}, {"sha256", "abc"}, {"hash", hash}, {"points", 17}}));
  EXPECT_EQ(json["input"]["files"].size(), 2U);
  EXPECT_EQ(json["input"]["units"], "mm");
  EXPECT_EQ(json["input"]["origin"], Json({500000.5, 4000000.25, 100.125}));
  EXPECT_EQ(json["input"]["invalid_points"], 3);
  EXPECT_EQ(json["options"]["method"], "paper");
  EXPECT_EQ(json["options"]["tank"], Json({1.0, 2.0, 3.0}));
  EXPECT_EQ(json["options"]["stations"]["clockwise"], true);
  EXPECT_EQ(keysOf(json["options"]),
            (std::vector<std::string>{"method", "locate", "crop", "normals", "growing", "centre_filter", "spline",
                                      "setups", "refine", "stations", "analysis", "shell", "pick", "accept", "level",
                                      "up", "las_classes", "tank", "movement"}));
}

}  // namespace tank_datum::datum_json_test
