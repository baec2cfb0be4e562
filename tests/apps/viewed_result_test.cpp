#include "view/viewed_result.h"

#include <gtest/gtest.h>

#include "io/pcd_writer.h"
#include "support/made_datums.h"
#include "support/pcd_files.h"
#include "support/refused.h"

namespace tank_datum::view::viewed_result_test {

using made_datums::octagon;
using pcd_files::Folder;

/// A row of points 1 cm apart from (500000, 4000000, 100) on.
std::string writeScan(const std::string& path, int points) {
  PcdWriter writer(path, {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}});
  for (int i = 0; i < points; ++i) writer.append({500000.0 + 0.01 * i, 4000000.0, 100.0});
  writer.commit();
  return path;
}

/// Results of the octagon whose scan is `scan`.
std::string writeOctagon(const Folder& folder, const std::string& scan, std::uint64_t points = 3) {
  std::filesystem::create_directory(folder.path("out"));
  Provenance from;
  from.files = {{scan, points, Checksum::Sha256, "abc"}};
  writeResults(folder.path("out"), octagon(), from);
  return folder.path("out");
}

std::string refusalOf(const std::string& folder) {
  return refusalOf(Error::Kind::File, [&] { readResult(folder, {}); });
}

TEST(ReadResult, GivesBackWhatWasWritten) {
  const Folder folder;
  const std::string scan = writeScan(folder.path("a.pcd"), 3);
  const ViewedResult result = readResult(writeOctagon(folder, scan), {});
  const Datum datum = octagon();
  EXPECT_TRUE(result.usable);
  EXPECT_EQ(result.status, "partial");
  EXPECT_EQ(result.scans, std::vector<std::string>{scan});
  EXPECT_EQ(result.origin, datum.origin);
  EXPECT_NEAR((result.circle.center - datum.circle.center).norm(), 0.0, 1e-8);
  EXPECT_EQ(result.circle.radius, 10.0);
  EXPECT_EQ(result.stations.size(), 8U);
  ASSERT_EQ(result.edge_points.size(), 2U);
  EXPECT_NEAR((result.edge_points[1] - datum.edge_points[1]).norm(), 0.0, 1e-8);
}

TEST(ReadResult, LooksForTheScanBesideTheFolderAndWhereItIsTold) {
  const Folder folder;
  const std::string out = writeOctagon(folder, "/gone/a.pcd");
  EXPECT_NE(refusalOf(out).find("/gone/a.pcd"), std::string::npos);
  EXPECT_EQ(readResult(out, {"other.pcd"}).scans, std::vector<std::string>{"other.pcd"});
  const std::string scan = writeScan(folder.path("a.pcd"), 3);
  EXPECT_EQ(readResult(out, {}).scans, std::vector<std::string>{scan});
}

TEST(ReadResult, OfNothingUsableSaysWhy) {
  const Folder folder;
  Datum none;
  none.status = Status::NoTank;
  none.message = "nothing stands there";
  writeResults(folder.path(""), none, Provenance());
  const ViewedResult result = readResult(folder.path(""), {});
  EXPECT_FALSE(result.usable);
  EXPECT_EQ(result.status, "no_tank");
  EXPECT_EQ(result.message, "nothing stands there");
}

TEST(ReadResult, NamesAFileThatIsNoResult) {
  const Folder folder;
  EXPECT_NE(refusalOf(folder.path("")).find("datum.json"), std::string::npos);
  for (const char* text : {"{", "[]", "{\"status\": 3}", "{\"status\": \"ok\", \"message\": \"\", \"datum\": {}}"}) {
    folder.file("datum.json", text);
    EXPECT_NE(refusalOf(folder.path("")).find("datum.json"), std::string::npos) << text;
  }
}

TEST(ThinnedCloud, IsInTheResultsFrameAndWithinTheBudget) {
  const Folder folder;
  const std::string scan = writeScan(folder.path("a.pcd"), 5000);
  const ViewedResult result = readResult(writeOctagon(folder, scan, 5000), {});
  const Points all = thinnedCloud(result, 10'000);
  ASSERT_EQ(all.size(), 5000U);
  EXPECT_NEAR((all.front() + result.origin - Eigen::Vector3d(500000, 4000000, 100)).norm(), 0.0, 1e-8);
  const Points thin = thinnedCloud(result, 1000);
  EXPECT_LE(thin.size(), 1000U);
  EXPECT_GE(thin.size(), 250U);
}

TEST(ThinnedCloud, HasTheUnitsOfTheScan) {
  const Folder folder;
  ViewedResult result = readResult(writeOctagon(folder, writeScan(folder.path("a.pcd"), 3)), {});
  result.metres_per_unit = 0.001;
  EXPECT_NEAR((thinnedCloud(result, 1000).front() + result.origin - Eigen::Vector3d(500, 4000, 0.1)).norm(), 0.0, 1e-6);
}

TEST(ExtractResult, OfNoTankSaysSo) {
  const Folder folder;
  const ViewedResult result = extractResult(writeScan(folder.path("a.pcd"), 5000), 1.0);
  EXPECT_FALSE(result.usable);
  EXPECT_EQ(result.status, "no_tank");
}

TEST(ThinnedCloud, RefusesAScanOfOtherPoints) {
  const Folder folder;
  const std::string scan = writeScan(folder.path("a.pcd"), 4);
  const ViewedResult other = readResult(writeOctagon(folder, scan), {});
  EXPECT_NE(refusalOf(Error::Kind::File, [&] { thinnedCloud(other, 100); }).find("4 points"), std::string::npos);
  EXPECT_EQ(thinnedCloud(readResult(folder.path("out"), {scan}), 100).size(), 4U);  // named by its user
}

TEST(ThinnedCloud, IsTurnedAsTheScanWas) {
  ViewedResult result;
  const Folder folder;
  result.scans = {writeScan(folder.path("a.pcd"), 2)};
  result.up = "y";
  const Points points = thinnedCloud(result, 100);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR((points[0] - Eigen::Vector3d(500000.0, -100.0, 4000000.0)).norm(), 0.0, 1e-6);
}

TEST(NearTank, KeepsAQuarterOfTheRadiusAround) {
  ViewedResult result;
  result.circle.center = {1.0, 0.0};
  result.circle.radius = 8.0;
  const Points cloud = {{1.0, 0.0, 50.0}, {10.9, 0.0, 0.0}, {11.1, 0.0, 0.0}};
  EXPECT_EQ(nearTank(cloud, result).size(), 2U);
}

}  // namespace tank_datum::view::viewed_result_test
