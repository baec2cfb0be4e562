#include "movement/baseline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "support/made_datums.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/report/report.h"

namespace tank_datum::baseline_test {

using made_datums::octagon;
using made_datums::provenance;

/// The octagon's datum.json in a file of its own.
class BaselineFile : public ::testing::Test {
 protected:
  void SetUp() override { write(datumJson(octagon(), provenance())); }

  void write(const std::string& text) const { folder_.file("baseline.json", text); }
  std::string refusal(const DatumOptions& current = {}, const MovementOptions& options = {}) const {
    try {
      readBaseline(path_, options, current);
    } catch (const Error& error) {
      return std::string(error.kind() == Error::Kind::File ? "file: " : "option: ") + error.what();
    }
    return "";
  }

  const TestFolder folder_;
  const std::string path_ = folder_.path("baseline.json");
};

TEST_F(BaselineFile, IsTheDatumThatWasWritten) {
  const Epoch read = readBaseline(path_, {}, {}).epoch, made = epochOf(octagon(), Method::Refined, path_);
  EXPECT_EQ(read.status, made.status);
  EXPECT_EQ(read.surface, made.surface);
  EXPECT_EQ(read.circle.center, made.circle.center);
  ASSERT_EQ(read.stations.size(), made.stations.size());
  for (std::size_t i = 0; i < made.stations.size(); ++i) {
    EXPECT_NEAR(read.stations[i].direction, made.stations[i].direction, 1e-11);
    EXPECT_EQ(std::isnan(read.stations[i].z), i == 5 || i == 6);  // interpolated and missing ones are no measurement
    if (i != 5 && i != 6) {
      EXPECT_EQ(read.stations[i].z, made.stations[i].z);
    }
  }
}

TEST_F(BaselineFile, IsRefusedWhileItsResultsAreIncomplete) {
  namespace fs = std::filesystem;
  const fs::path folder = path_ + ".folder", journal = folder / ".tank_datum-commit" / "journal.json";
  fs::create_directories(journal.parent_path());
  fs::create_directories(folder / "tank_1");
  for (const fs::path& place : {folder, folder / "tank_1"}) fs::copy_file(path_, place / "datum.json");
  std::ofstream(journal) << "{}";
  const auto refused = [](const fs::path& path) -> std::string {
    try {
      readEpoch(path.string());
    } catch (const Error& error) {
      return error.kind() == Error::Kind::File ? error.what() : "";
    }
    return "";
  };
  for (const fs::path& path : {folder, folder / "datum.json", folder / "tank_1"}) {
    EXPECT_NE(refused(path).find("results incomplete since a run was stopped"), std::string::npos) << path;
  }
  fs::remove(journal);
  EXPECT_EQ(refused(folder), "");
}

TEST_F(BaselineFile, IsRefusedWhenUnusable) {
  EXPECT_EQ(refusal(), "");
  write("{");
  EXPECT_EQ(refusal().rfind("file: epoch", 0), 0U) << refusal();
  Datum none;
  none.status = Status::NoTank;
  write(datumJson(none, provenance()));
  EXPECT_NE(refusal().find("option: movement: baseline"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("no_tank"), std::string::npos);
  std::filesystem::remove(path_);
  EXPECT_EQ(refusal().rfind("file: epoch", 0), 0U);
}

TEST_F(BaselineFile, IsRefusedForAnotherMethodOrTank) {
  DatumOptions paper, given;
  paper.method = Method::Paper;
  EXPECT_NE(refusal(paper).find("no standard errors"), std::string::npos);
  Provenance from = provenance();
  from.options.method = Method::Paper;
  write(datumJson(octagon(), from));
  EXPECT_NE(refusal().find("of method paper"), std::string::npos);
  SetUp();
  given.tank = Circle{{500001.5, 4000002.25}, 10.1};
  EXPECT_EQ(refusal(given), "");
  given.tank->radius = 12.0;
  EXPECT_NE(refusal(given).find("radius of option tank"), std::string::npos);
  MovementOptions bad;
  bad.correlation = -1.0;
  EXPECT_NE(refusal({}, bad).find("correlation_deg"), std::string::npos);
}

TEST_F(BaselineFile, MustBeAmongTheTanksOfTheScan) {
  const Baseline baseline = readBaseline(path_, {}, {});
  Tank far, same;
  far.circle = {{50.0, 2.0}, 10.0};
  same.circle = {{1.02, 2.0}, 10.03};
  same.resolution = far.resolution = 0.05;
  const Eigen::Vector3d origin = octagon().origin;
  EXPECT_NO_THROW(requireAmong({far, same}, origin, baseline));
  EXPECT_THROW(requireAmong({far}, origin, baseline), Error);
  EXPECT_NO_THROW(requireAmong({}, origin, baseline));  // no tank at all is the result's to say
  same.circle.radius = 10.3;
  EXPECT_THROW(requireAmong({same}, origin, baseline), Error);
}

}  // namespace tank_datum::baseline_test
