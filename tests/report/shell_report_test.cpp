#include "report/shell_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/made_datums.h"

namespace tank_datum::shell_report_test {

using Json = nlohmann::ordered_json;

/// Two heights of which one has a circle, two stations seen at both.
ShellSurvey survey() {
  ShellSurvey made;
  made.points = {{0.0, 0.3, 10.001, 0.001, 0.0, 0.00025, 150}, {kDegree, 1.3, 10.003, NAN, 0.0025, 0.00045, 60}};
  Roundness r;
  r.height = 0.3, r.circle = {{0, 0}, 10.0}, r.max_deviation = 0.0125, r.min_deviation = -0.02;
  r.azimuth = 120 * kDegree, r.sigma = 0.0001, r.stations = 359, r.widest_gap = 0.35;
  made.roundness = {r};
  made.plumbness = {{0.0, 0.0, 1.0, -0.004, 0.0003, -0.0041, NAN},
                    {kDegree, kDegree, 1.0, 0.0025, 0.0003, 0.0025, 0.0001}};
  made.lean = {{0.003, 0.004}, 0.0002, 53 * kDegree, 1.0};
  return made;
}

const std::vector<LimitComparison> kFails = {{0.019, Verdict::Fail}};

TEST(ShellJson, HasTheAgreedKeys) {
  const Json json = shellJson(survey(), kFails);
  EXPECT_EQ(json["roundness"], Json::parse(R"([{"height": 0.3, "radius": 10.0, "max_deviation": 0.0125,
    "min_deviation": -0.02, "azimuth_deg": 120.0, "sigma": 0.0001, "n": 359, "widest_gap": 0.35, "tolerance": 0.019,
    "verdict": "fail"}])"));
  ASSERT_EQ(json["plumbness"].size(), 2U);
  EXPECT_EQ(json["plumbness"][0], Json::parse(R"({"azimuth_deg": 0.0, "height": 1.0, "offset": -0.004, "sigma": 0.0003,
    "slope": -0.0041, "sigma_slope": null})"));
  EXPECT_EQ(json["plumbness_max"], 0.004);
  EXPECT_EQ(json["plumbness_sigma"], 0.0003);
  EXPECT_EQ(json["plumbness_height"], 1.0);
  EXPECT_EQ(json["plumbness_azimuth_deg"], 0.0);
  EXPECT_NEAR(json["lean"]["slope"], 0.005, 1e-12);
  EXPECT_NEAR(json["lean"]["direction_deg"], 53.0, 1e-9);
  EXPECT_NEAR(json["lean"]["offset"], 0.005, 1e-12);
}

TEST(ShellJson, OfOneHeightHasNoPlumbness) {
  ShellSurvey one = survey();
  one.plumbness.clear();
  one.lean = {};
  const Json json = shellJson(one, kFails);
  EXPECT_TRUE(json["plumbness"].is_array() && json["plumbness"].empty());
  EXPECT_TRUE(json["plumbness_max"].is_null());
  EXPECT_TRUE(json["plumbness_azimuth_deg"].is_null());
  EXPECT_TRUE(json["lean"].is_null());
}

TEST(ShellJson, IsASectionOfAUsableDatumOnly) {
  Datum datum = made_datums::octagon();
  EXPECT_FALSE(Json::parse(datumJson(datum, made_datums::provenance())).contains("shell"));
  datum.shell = survey();
  datum.analysis.roundness = kFails;
  EXPECT_EQ(Json::parse(datumJson(datum, made_datums::provenance()))["shell"], shellJson(survey(), kFails));
  EXPECT_TRUE(shellJson(survey(), {})["roundness"][0]["tolerance"].is_null());
}

TEST(ShellCsv, IsARowPerHeightAndStationUnknownEmpty) {
  EXPECT_EQ(shellCsv(survey()),
            "azimuth_deg,height,radius,deviation,sigma,n,offset\n"
            "0,0.3,10.001,0.001,0.00025,150,0\n"
            "1,1.3,10.003,,0.00045,60,0.0025\n");
  EXPECT_EQ(shellCsv({}), "azimuth_deg,height,radius,deviation,sigma,n,offset\n");
}

TEST(ShellSummary, SaysTheWorstOrWhyThereIsNone) {
  EXPECT_EQ(
      shellSummary(survey(), kFails),
      "roundness      +12.5 / -20.0 mm at 0.30 m above the datum, worst at 120 deg (tolerance 19 mm: fail)\n"
      "plumbness      -4.0 +- 0.6 mm (2 sigma) over 1.0 m of height at 0 deg; the tank leans 5.0 mm +- 0.4 mm towards "
      "53 deg\n");
  EXPECT_NE(shellSummary(survey(), {{0.0001, Verdict::Undecided}}).find("(tolerance 0.1 mm: undecided)"),
            std::string::npos);
  EXPECT_NE(shellSummary(survey(), {{}}).find("worst at 120 deg (no tolerance for it)"), std::string::npos);
  EXPECT_NE(shellSummary(survey(), {{0.019, Verdict::NotApplicable, "new"}}).find("(tolerance of new tanks 19 mm)"),
            std::string::npos);
  ShellSurvey upright = survey();
  upright.lean.gradient = {0.00001, 0.00001};
  EXPECT_EQ(shellSummary(upright, kFails).find("leans"), std::string::npos);  // 0.0 mm has no direction
  ShellSurvey none;
  EXPECT_EQ(shellSummary(none, {}), "");
  none.message = "the scan holds no shell 0.3 m or more above the datum";
  EXPECT_EQ(shellSummary(none, {}), "shell          the scan holds no shell 0.3 m or more above the datum\n");
  ShellSurvey part = survey();
  part.roundness.clear();
  part.plumbness.clear();
  EXPECT_EQ(shellSummary(part, {}),
            "roundness      the shell is not seen round enough of the tank at any height\n"
            "plumbness      the shell is seen at one height only\n");
}

}  // namespace tank_datum::shell_report_test
