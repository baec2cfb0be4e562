#include "report/report_page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/made_datums.h"
#include "support/pcd_files.h"
#include "tank_datum/core/error.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum::report_page_test {

using Json = nlohmann::json;
using made_datums::octagon;
using made_datums::provenance;
using pcd_files::Folder;
using pcd_files::readAll;

/// What stands in the page's script element of that id.
std::string dataOf(const std::string& page, const std::string& id) {
  const auto mark = page.find("id=\"data-" + id + "\">");
  if (mark == std::string::npos) return {};
  const auto from = page.find('>', mark) + 1;
  return page.substr(from, page.find("</script>", from) - from);
}

TEST(EscapedForScript, IsTheSameJsonWithoutMarkup) {
  const std::string json = R"({"path": "</script><!--&\u2028é)"
                           "\xE2\x80\xA8\xE2\x80\xA9\xE2\x80\xAA"
                           R"("})";
  const std::string escaped = escapedForScript(json);
  EXPECT_EQ(escaped.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(escaped.find("\xE2\x80\xA8"), std::string::npos);
  EXPECT_EQ(escaped.find("\xE2\x80\xA9"), std::string::npos);
  EXPECT_NE(escaped.find("\xE2\x80\xAA"), std::string::npos);  // its neighbour is left alone
  EXPECT_EQ(Json::parse(escaped), Json::parse(json));
  EXPECT_EQ(escapedForScript("{\"a\": [1, 2]}\n"), "{\"a\": [1, 2]}\n");
}

TEST(PageWith, CarriesItsData) {
  const std::string page = pageWith({{"a", "application/json", "{\"x\": \"<\"}"}, {"b", "text/csv", "1,2\n"}});
  EXPECT_EQ(dataOf(page, "a"), "{\"x\": \"\\u003c\"}");
  EXPECT_EQ(dataOf(page, "b"), "1,2\n");
  EXPECT_EQ(page.find("@data@"), std::string::npos);
  EXPECT_EQ(page.compare(0, 15, "<!DOCTYPE html>"), 0);
  EXPECT_NE(page.find("</html>"), std::string::npos);
}

TEST(PageWith, RefusesATableWithMarkup) {
  try {
    pageWith({{"stations", "text/csv", "a,<b>\n"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("stations"), std::string::npos);
  }
}

TEST(ReportPage, HoldsTheResultsAsTheFilesDo) {
  const std::string page = reportPage(octagon(), provenance());
  EXPECT_EQ(Json::parse(dataOf(page, "datum")), Json::parse(datumJson(octagon(), provenance())));
  EXPECT_EQ(dataOf(page, "stations"), stationsCsv(octagon()));
  EXPECT_EQ(page.find("id=\"data-sections\""), std::string::npos);
}

TEST(ReportPage, HoldsSectionsInTheScansFrame) {
  Datum datum = octagon();
  StationProfile section;
  section.base = 0.5;
  section.points = {{0.1F, -0.00123F}, {-0.0005F, 0.25F}};
  section.foundation = 0.0012345678, section.slope = -0.02;
  datum.refined.sections.assign(8, section);
  const Json json = Json::parse(dataOf(reportPage(datum, provenance()), "sections"));
  ASSERT_EQ(json["stations"].size(), 8U);
  const Json& first = json["stations"][0];
  EXPECT_EQ(json["step"], 1e-4);
  EXPECT_EQ(json["side"], "outside");
  EXPECT_EQ(json["band"], Json({0.015, 0.06}));
  EXPECT_NEAR(first["base"], 100.625, 1e-12);
  EXPECT_EQ(first["d"], Json({1000, -5}));
  EXPECT_EQ(first["z"], Json({-12, 2500}));
  EXPECT_EQ(first["foundation"], 0.00123457);
  EXPECT_EQ(first["slope"], -0.02);
  EXPECT_TRUE(first["lean"].is_null());
  datum.tank.side = Side::Inside;
  EXPECT_EQ(Json::parse(dataOf(reportPage(datum, provenance()), "sections"))["side"], "inside");
}

TEST(TrendPage, HoldsTheMovementsAlone) {
  const std::string page = trendPage("{\"movements\": []}", "azimuth_deg,trend\n0,1\n", "data:image/png;base64,AAAA");
  EXPECT_EQ(dataOf(page, "movements"), "azimuth_deg,trend\n0,1\n");
  EXPECT_EQ(dataOf(page, "trend"), "{\"movements\": []}");
  EXPECT_EQ(dataOf(page, "logo"), "\"data:image/png;base64,AAAA\"");
  EXPECT_EQ(page.find("id=\"data-datum\""), std::string::npos);
}

TEST(WriteReportPage, WritesItOrNamesThePath) {
  const Folder folder;
  writeReportPage(folder.path(""), "page");
  EXPECT_EQ(readAll(folder.path("report.html")), "page");
  try {
    writeReportPage(folder.path("none"), "page");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::File);
    EXPECT_NE(std::string(error.what()).find("none/report.html"), std::string::npos);
  }
}

}  // namespace tank_datum::report_page_test
