#include "report/provenance.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "io/input_file.h"
#include "io/sha256.h"
#include "support/made_datums.h"
#include "support/pcd_files.h"

namespace tank_datum::provenance_test {

using Json = nlohmann::json;

constexpr const char* kText = "1 2 3\n4 5 6\n";
// of these bytes, as xxhsum -H2 and sha256sum print them
constexpr const char* kXxh3 = "351ab452f38bcfd825407e1a4f8d16db";
constexpr const char* kSha256 = "2f55dcfd243b52536b4b8ef0fbfae93ee153fc2f0355888c26bd2b709cddd4cd";

Json fileJsonOf(const InputRecord& record) {
  Provenance from;
  from.files = {record};
  return Json::parse(datumJson(Datum(), from))["input"]["files"][0];
}

TEST(RecordInputs, AHashOfTheKindAskedFor) {
  const pcd_files::Folder folder;
  const std::string path = folder.file("a.xyz", kText);
  const Scan scan = Scan::open({path});
  Json expected = {{"path", path}, {"points", 2}, {"sha256", nullptr}, {"hash", nullptr}};
  EXPECT_EQ(fileJsonOf(recordInputs(scan, Checksum::None).front()), expected);
  expected["hash"] = {{"algorithm", "xxh3_128"}, {"value", kXxh3}};
  EXPECT_EQ(fileJsonOf(recordInputs(scan).front()), expected);
  expected["hash"] = {{"algorithm", "sha256"}, {"value", kSha256}};
  expected["sha256"] = kSha256;
  EXPECT_EQ(fileJsonOf(recordInputs(scan, Checksum::Sha256).front()), expected);
  expected["hash"] = expected["sha256"] = nullptr;
  for (const Checksum checksum : {Checksum::Xxh3, Checksum::Sha256}) {
    EXPECT_EQ(fileJsonOf(recordInputs(scan, checksum, [] { return false; }).front()), expected);
  }
}

TEST(RecordInputs, CountsTheRowsOfEachFile) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({folder.file("a.xyz", kText), folder.file("b.xyz", "1 2 nan\n")});
  const auto files = recordInputs(scan);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].points, 2U);
  EXPECT_EQ(files[1].points, 1U);
  EXPECT_TRUE(recordInputs(Scan::fromPoints({{1, 2, 3}})).empty());
}

/// A hash of other bytes than the result is of would be worse than none.
TEST(RecordInputs, OfAFileThatChangedAreRefused) {
  for (const Checksum checksum : {Checksum::None, Checksum::Xxh3, Checksum::Sha256}) {
    const pcd_files::Folder folder;
    const Scan scan = Scan::open({folder.file("a.xyz", kText)});
    folder.file("a.xyz", std::string(kText) + "7 8 9\n");
    EXPECT_NE(pcd_files::errorOf([&] { recordInputs(scan, checksum); }).find("changed meanwhile"), std::string::npos);
  }
}

TEST(ReadRecordedLevelling, HasAHashOfTheKindAskedFor) {
  const pcd_files::Folder folder;
  RunOptions run;
  run.levelling = folder.file("a.csv", "azimuth_deg,elevation\n0,1\n90,1\n180,1\n270,1\n");
  run.diameter = 10.0;
  const std::map<Checksum, std::string> expected = {{Checksum::None, ""},
                                                    {Checksum::Xxh3, InputFile(run.levelling).xxh3()},
                                                    {Checksum::Sha256, sha256OfFile(run.levelling)}};
  for (const auto& [checksum, hash] : expected) {
    run.checksum = checksum;
    const RecordedDatum levelled = readRecordedLevelling(run);
    EXPECT_EQ(levelled.file.hash, hash);
    EXPECT_EQ(levelled.file.points, 4U);
    EXPECT_TRUE(levelled.datum.levelled);
  }
}

}  // namespace tank_datum::provenance_test
