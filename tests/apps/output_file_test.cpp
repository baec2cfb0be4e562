#include "results/output_file.h"

#include <gtest/gtest.h>

#include "apps/result_folder_fixture.h"
#include "results/output_guard.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"

namespace tank_datum::output_file_test {

using OutputFileTest = ResultFolderFixture;

std::string refusal(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
  return refusalOf(Error::Kind::Option, [&] { requireApart(inputs, outputs); });
}

TEST_F(OutputFileTest, OutputsThatAreInputsAreRefused) {
  write("out/datum_points.pcd", "a scan");
  write("out/tank_5/stations.csv", "a table");
  write("out/tank_5x/stations.csv", "no tank's folder");
  write("scan.pcd", "another");
  write("base/datum.json", "{}");
  fs::create_hard_link(dir_ / "scan.pcd", dir_ / "out/stations.csv");
  fs::create_symlink(dir_ / "out/datum_points.pcd", dir_ / "link.pcd");
  const auto outputs = outputsOf(path("out"), "tank_datum");
  EXPECT_NE(refusal({{"scan", path("out/datum_points.pcd")}}, outputs).find("this is the scan"), std::string::npos);
  EXPECT_NE(refusal({{"scan", path("scan.pcd")}}, outputs), "");  // a hard link of it
  EXPECT_NE(refusal({{"scan", path("link.pcd")}}, outputs), "");  // leads to it
  EXPECT_NE(refusal({{"t", path("out/tank_5/stations.csv")}}, outputs), "");
  EXPECT_NE(refusal({{"t", path("out/../out/manifest.json")}}, outputs), "");  // not there yet
  EXPECT_NE(refusal({{"t", path("out/.//shell.csv")}}, outputs), "");
  EXPECT_NE(refusal({{"scan", path("scan.pcd")}}, outputsOf(path("scan.pcd"), "tank_datum")), "");
  EXPECT_EQ(refusal({{"t", path("out/tank_5x/stations.csv")}}, outputs), "");
  EXPECT_EQ(refusal({{"t", path("out/other.csv")}, {"none", ""}}, outputs), "");
  EXPECT_NE(refusal(inputsOf("survey", path("base/datum.json")), outputsOf(path("base"), "tank_datum_compare")), "");
  EXPECT_NE(refusal(inputsOf("survey", path("base")), outputsOf(path("base"), "tank_datum_compare")), "");
  EXPECT_EQ(refusal(inputsOf("survey", path("base")), outputsOf(path("moved"), "tank_datum_compare")), "");
}

TEST_F(OutputFileTest, ANamedFileReplacesOnlyItsOwn) {
  const auto put = [&](const std::string& name, const std::string& content) {
    OutputFile file(path(name), isJsonWith({"stages", "total"}), "tank_datum");
    file.write(content);
    testing::internal::CaptureStderr();
    file.commit();
    said_ = testing::internal::GetCapturedStderr();
  };
  write("t.json", "a scan");
  put("t.json", R"({"stages": 1, "total": 2})");
  EXPECT_EQ(read("t.kept.json"), "a scan");
  EXPECT_NE(said_.find("is not of this program: kept as"), std::string::npos);
  put("t.json", R"({"stages": 2, "total": 2})");
  EXPECT_EQ(said_, "");
  EXPECT_EQ(read("t.json"), R"({"stages": 2, "total": 2})");
  fs::create_directory(dir_ / "sub");
  fs::create_symlink("../t.json", dir_ / "sub/link.json");
  put("sub/link.json", R"({"stages": 3, "total": 2})");
  EXPECT_TRUE(fs::is_symlink(dir_ / "sub/link.json"));
  EXPECT_EQ(read("t.json"), R"({"stages": 3, "total": 2})");
  EXPECT_EQ(entries("."), 3U);
  EXPECT_THROW(put("sub", "{}"), Error);
}

TEST_F(OutputFileTest, FilesAreKnownByTheirHead) {
  const IsOwn own = isFileWith("# .PCD", "# made by x\n");
  write("a.pcd", "# .PCD v0.7\n# made by x\nVERSION 0.7\n");
  write("b.pcd", "# .PCD v0.7\nVERSION 0.7\n");
  write("c.pcd", "# made by x\n");
  write("d.pcd", "# .PCD v0.7\n" + std::string(2000, ' ') + "# made by x\n");
  EXPECT_TRUE(own(path("a.pcd")));
  for (const char* other : {"b.pcd", "c.pcd", "d.pcd"}) EXPECT_FALSE(own(path(other))) << other;
  EXPECT_THROW(own(path("none")), Error);  // what cannot be read is not taken for anything
}
TEST_F(OutputFileTest, ADashIsNoFile) {
  EXPECT_EQ(refusalOf(Error::Kind::Option, [] { const OutputFile file("-", isReportPage(), "tank_datum"); }),
            "command line: an output file, -, expected its name, or ./- for one of that name");
}

}  // namespace tank_datum::output_file_test
