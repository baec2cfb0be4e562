#include "results/result_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "apps/result_folder_fixture.h"
#include "io/sha256.h"
#include "results/manifest.h"
#include "results/plan.h"

namespace tank_datum::result_folder_test {

using ResultFolderTest = ResultFolderFixture;

/// What a result before there were manifests is known by.
constexpr const char* kDatumJson = R"({"schema":1,"version":"0","input":{},"options":{},"status":"ok"})";

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
  EXPECT_NE(said_.find("out/report.html is of tank_datum: kept as"), std::string::npos) << said_;
  run({{"datum.json", "2"}});
  EXPECT_EQ(read("out/movement.json"), "1");
  EXPECT_EQ(read("out/report.html"), "of the movement");
  EXPECT_EQ(results::Manifest::of(path("out"))->files.size(), 3U);
}

TEST_F(ResultFolderTest, TheRootIsAFolderToo) {
  write("report.html", "mine");
  const std::string name = path("report.html").substr(1), kept = path("report.kept.html");
  const results::Plan plan = results::planOf("/", "tank_datum", {{name, ""}});
  ASSERT_EQ(plan.journal.displaced.size(), 1U);
  EXPECT_EQ(plan.journal.displaced[0].second, kept.substr(1));
  EXPECT_EQ(plan.said[0], "/" + name + " is not of this program: kept as " + kept);
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
  EXPECT_NE(resultsLeft(path("out"), "tank_datum", false).find("holds the results of an earlier run"),
            std::string::npos);
  EXPECT_EQ(resultsLeft(path("out"), "tank_datum_compare", false), "");
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

}  // namespace tank_datum::result_folder_test
