#include "results/result_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/sha256.h"
#include "results/manifest.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

/// What a result before there were manifests is known by.
constexpr const char* kDatumJson = R"({"schema":1,"version":"0","input":{},"options":{},"status":"ok"})";

class ResultFolderTest : public testing::Test {
 protected:
  ResultFolderTest() {
    std::string name = (fs::temp_directory_path() / "results-XXXXXX").string();
    dir_ = fs::path(mkdtemp(name.data()));
  }
  ~ResultFolderTest() override { fs::remove_all(dir_); }

  std::string path(const std::string& name) const { return (dir_ / name).string(); }
  bool has(const std::string& name) const { return fs::exists(fs::symlink_status(dir_ / name)); }
  std::string read(const std::string& name) const {
    std::ifstream in(dir_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& name, const std::string& content) const {
    fs::create_directories((dir_ / name).parent_path());
    std::ofstream(dir_ / name) << content;
  }
  /// A run that writes files, each with a content, into out/.
  void run(const std::vector<std::pair<std::string, std::string>>& files, const std::string& program = "tank_datum") {
    ResultFolder folder(path("out"), program);
    for (const auto& [name, content] : files) {
      const fs::path file(name);
      std::ofstream(folder.stage(file.parent_path().string()) + "/" + file.filename().string()) << content;
    }
    testing::internal::CaptureStderr();
    folder.commit();
    said_ = testing::internal::GetCapturedStderr();
  }
  std::size_t entries(const std::string& name) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(dir_ / name), fs::directory_iterator()));
  }

  fs::path dir_;
  std::string said_;
};

TEST_F(ResultFolderTest, ManifestNamesTheFilesAndTheirHashes) {
  run({{"datum.json", "abc"}, {"tank_1/datum.json", ""}});
  const auto manifest = results::Manifest::of(path("out"));
  ASSERT_TRUE(manifest);
  ASSERT_EQ(manifest->files.size(), 2U);
  EXPECT_EQ(manifest->files.at("datum.json").sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(manifest->files.at("tank_1/datum.json").sha256,
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(manifest->files.at("datum.json").program, "tank_datum");
  EXPECT_EQ(said_, "");
  EXPECT_EQ(entries("out"), 3U);
}

TEST_F(ResultFolderTest, OnlyOwnFilesGo) {
  run({{"datum.json", "1"}, {"datum_points.pcd", "1"}});
  write("out/tank_notes.txt", "mine");
  run({{"datum.json", "2"}});
  EXPECT_EQ(read("out/datum.json"), "2");
  EXPECT_FALSE(has("out/datum_points.pcd"));
  EXPECT_EQ(read("out/tank_notes.txt"), "mine");
  EXPECT_EQ(said_, "");
}

TEST_F(ResultFolderTest, AChangedFileIsKeptUnderAnotherName) {
  run({{"report.html", "1"}, {"datum_points.pcd", "1"}});
  write("out/report.html", "edited");
  write("out/datum_points.pcd", "edited too");
  run({{"report.html", "2"}});
  EXPECT_EQ(read("out/report.html"), "2");
  EXPECT_EQ(read("out/report.kept.html"), "edited");
  EXPECT_EQ(read("out/datum_points.kept.pcd"), "edited too");
  EXPECT_FALSE(has("out/datum_points.pcd"));
  EXPECT_NE(said_.find("out/report.html was changed since it was written: kept as"), std::string::npos);
  write("out/report.html", "again");
  run({{"report.html", "3"}});
  EXPECT_EQ(read("out/report.kept.html"), "edited");
  EXPECT_EQ(read("out/report.kept-2.html"), "again");
}

TEST_F(ResultFolderTest, WhatOthersCalledTheSameIsKept) {
  write("out/datum.json", R"({"datum": "WGS 84"})");
  write("out/manifest.json", R"({"name": "of a web page"})");
  fs::create_directory_symlink(dir_, dir_ / "out/tank_1");
  write("out/stations.csv/inside", "a folder");
  run({{"datum.json", "1"}, {"stations.csv", "1"}, {"tank_1/datum.json", "1"}});
  EXPECT_EQ(read("out/datum.kept.json"), R"({"datum": "WGS 84"})");
  EXPECT_EQ(read("out/manifest.kept.json"), R"({"name": "of a web page"})");
  EXPECT_EQ(fs::read_symlink(dir_ / "out/tank_1.kept"), dir_);
  EXPECT_EQ(read("out/stations.kept.csv/inside"), "a folder");
  EXPECT_EQ(read("out/tank_1/datum.json"), "1");
  EXPECT_FALSE(has("datum.json"));  // where the link leads
}

TEST_F(ResultFolderTest, OfARunBeforeManifestsTheContractsNamesGo) {
  for (const std::string part : {"out/", "out/tank_1/", "out/tank_3/"}) {
    write(part + "datum.json", kDatumJson);
    write(part + "stations.csv", "old");
    write(part + "notes.csv", "mine");
  }
  run({{"datum.json", "1"}, {"tank_1/datum.json", "1"}});
  EXPECT_EQ(read("out/datum.json"), "1");
  EXPECT_EQ(read("out/tank_1/datum.json"), "1");
  EXPECT_FALSE(has("out/stations.csv"));
  EXPECT_FALSE(has("out/tank_1/stations.csv"));
  EXPECT_EQ(read("out/tank_3/stations.csv"), "old");  // not this run's, and no manifest names it
  for (const char* part : {"out/", "out/tank_1/", "out/tank_3/"})
    EXPECT_EQ(read(part + std::string("notes.csv")), "mine");
  EXPECT_EQ(said_, "");
}

TEST_F(ResultFolderTest, OnlyNamedTankFoldersGo) {
  run({{"tank_1/datum.json", "1"}, {"tank_2/datum.json", "1"}, {"tank_3/datum.json", "1"}});
  write("out/tank_3/photo.jpg", "mine");
  write("out/tank_4/datum.json", kDatumJson);
  run({{"tank_1/datum.json", "2"}});
  EXPECT_FALSE(has("out/tank_2"));
  EXPECT_EQ(entries("out/tank_3"), 1U);
  EXPECT_EQ(read("out/tank_3/photo.jpg"), "mine");
  EXPECT_EQ(read("out/tank_4/datum.json"), kDatumJson);
}

TEST_F(ResultFolderTest, ProgramsShareAFolder) {
  run({{"datum.json", "1"}, {"report.html", "of the datum"}});
  run({{"movement.json", "1"}, {"report.html", "of the movement"}}, "tank_datum_compare");
  EXPECT_EQ(read("out/datum.json"), "1");
  EXPECT_EQ(read("out/report.kept.html"), "of the datum");
  run({{"datum.json", "2"}});
  EXPECT_EQ(read("out/movement.json"), "1");
  EXPECT_EQ(read("out/report.html"), "of the movement");
  EXPECT_EQ(results::Manifest::of(path("out"))->files.size(), 3U);
}

TEST_F(ResultFolderTest, AManifestLeadsNowhereElse) {
  write("mine.txt", "mine");
  write("out/manifest.json", R"({"schema": 1, "files": [{"path": "../mine.txt", "program": "tank_datum", "sha256": ")" +
                                 sha256OfFile(path("mine.txt")) + "\"}]}");
  run({{"datum.json", "1"}});
  EXPECT_EQ(read("mine.txt"), "mine");
  fs::create_directory(dir_ / "elsewhere");
  run({{"tank_1/datum.json", "1"}});
  fs::rename(dir_ / "out/tank_1", dir_ / "elsewhere/tank_1");
  fs::create_directory_symlink(dir_ / "elsewhere/tank_1", dir_ / "out/tank_1");
  run({{"datum.json", "1"}});
  EXPECT_EQ(read("elsewhere/tank_1/datum.json"), "1");
}

TEST_F(ResultFolderTest, WithoutCommitNothingHappens) {
  run({{"datum.json", "1"}});
  {
    ResultFolder folder(path("out"), "tank_datum");
    std::ofstream(folder.stage("tank_1") + "/datum.json") << "2";
  }
  EXPECT_EQ(entries("out"), 2U);
  EXPECT_EQ(read("out/datum.json"), "1");
  EXPECT_NE(earlierResults(path("out"), "tank_datum").find("holds the results of an earlier run"), std::string::npos);
  EXPECT_EQ(earlierResults(path("out"), "tank_datum_compare"), "");
  { const ResultFolder folder(path("new/and/deep"), "tank_datum"); }
  EXPECT_FALSE(has("new"));
}

TEST_F(ResultFolderTest, OnlyStagingFoldersOfTheDeadGo) {
  write("out/.tank_datum-123-4/lock", "");
  write("out/.tank_datum-123-4/new/datum.json", "half");
  fs::create_directory(dir_ / "out/.tank_datum-99-1");
  write("out/.tank_datum-alive-1/lock", "a name of somebody else");
  write("out/.tank_datum-55-1/lock", "");
  write("out/.tank_datum-77-1/notes", "not ours");
  const int held = ::open(path("out/.tank_datum-55-1/lock").c_str(), O_RDWR);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  run({{"datum.json", "1"}});
  EXPECT_FALSE(has("out/.tank_datum-123-4"));
  EXPECT_FALSE(has("out/.tank_datum-99-1"));
  EXPECT_TRUE(has("out/.tank_datum-alive-1/lock"));
  EXPECT_TRUE(has("out/.tank_datum-55-1/lock"));
  EXPECT_TRUE(has("out/.tank_datum-77-1/notes"));
  ::close(held);
  run({{"datum.json", "1"}});
  EXPECT_FALSE(has("out/.tank_datum-55-1"));
}

std::string refusal(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
  try {
    requireApart(inputs, outputs);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Option);
    return error.what();
  }
  return "";
}

TEST_F(ResultFolderTest, OutputsThatAreInputsAreRefused) {
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

TEST_F(ResultFolderTest, ANamedFileReplacesOnlyItsOwn) {
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

TEST_F(ResultFolderTest, FilesAreKnownByTheirHead) {
  const IsOwn own = isFileWith("# .PCD", "# made by x\n");
  write("a.pcd", "# .PCD v0.7\n# made by x\nVERSION 0.7\n");
  write("b.pcd", "# .PCD v0.7\nVERSION 0.7\n");
  write("c.pcd", "# made by x\n");
  write("d.pcd", "# .PCD v0.7\n" + std::string(2000, ' ') + "# made by x\n");
  EXPECT_TRUE(own(path("a.pcd")));
  for (const char* other : {"b.pcd", "c.pcd", "d.pcd"}) EXPECT_FALSE(own(path(other))) << other;
  EXPECT_THROW(own(path("none")), Error);  // what cannot be read is not taken for anything
}

}  // namespace
}  // namespace tank_datum
