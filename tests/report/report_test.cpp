#include "tank_datum/report/report.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/made_datums.h"
#include "support/pcd_files.h"
#include "tank_datum/foot/refined.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::report_test {

/// Nothing of units and language.
const Provenance& nothingSaid() {
  static const Provenance none;
  return none;
}

using made_datums::octagon;
using made_datums::provenance;
using pcd_files::Folder;
using pcd_files::readAll;

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(Names, AreThoseOfTheFiles) {
  EXPECT_STREQ(nameOf(StationFlag::Measured), "measured");
  EXPECT_STREQ(nameOf(StationFlag::Interpolated), "interpolated");
  EXPECT_STREQ(nameOf(StationFlag::Missing), "missing");
  EXPECT_STREQ(nameOf(Status::NotRun), "not_run");
  EXPECT_STREQ(nameOf(Status::Ok), "ok");
  EXPECT_STREQ(nameOf(Status::Partial), "partial");
  EXPECT_STREQ(nameOf(Status::NoTank), "no_tank");
  EXPECT_STREQ(nameOf(Status::NoCrease), "no_crease");
  EXPECT_STREQ(nameOf(Status::TooFewPoints), "too_few_points");
  EXPECT_STREQ(nameOf(Status::FitFailed), "fit_failed");
  EXPECT_STREQ(nameOf(Method::Refined), "refined");
  EXPECT_STREQ(nameOf(Method::Paper), "paper");
}

TEST(StationsCsv, HasTheContractsHeaderAndARowPerStation) {
  const std::string csv = stationsCsv(octagon());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "station,azimuth_deg,x,y,z,sigma_z,radius,sigma_radius,n_shell,n_foundation,flag,z_paper,z_tilt,u,u_fit,"
            "curvature,n_setups,sigma_setup,reason");
  const auto rows = rowsOf(csv);
  ASSERT_EQ(rows.size(), 9U);
  for (const auto& row : rows) EXPECT_EQ(row.size(), 19U);
  EXPECT_EQ(csv.back(), '\n');
}

TEST(StationsCsv, IsInTheScansFrameInMetresAndDegrees) {
  const Datum datum = octagon();
  const auto row = rowsOf(stationsCsv(datum))[3];
  EXPECT_EQ(row[0], "2");
  EXPECT_EQ(std::stod(row[1]), 90.0);
  EXPECT_EQ(std::stod(row[2]), datum.stations[2].x + 500000.5);  // reads back as the same double
  EXPECT_EQ(std::stod(row[3]), datum.stations[2].y + 4000000.25);
  EXPECT_EQ(std::stod(row[4]), datum.stations[2].z + 100.125);
  EXPECT_EQ(std::stod(row[5]), 0.00025);
  EXPECT_EQ(std::stod(row[6]), 10.0);
  EXPECT_EQ(std::stod(row[7]), 0.0005);
  EXPECT_EQ(row[8], "102");
  EXPECT_EQ(row[9], "52");
  EXPECT_EQ(row[10], "measured");
  EXPECT_EQ(std::stod(row[11]), datum.stations[2].z_paper + 100.125);
  EXPECT_NEAR(std::stod(row[4]) - std::stod(row[12]), std::stod(row[13]), 1e-10);
}

TEST(StationsCsv, WhatIsUnknownIsEmpty) {
  const auto rows = rowsOf(stationsCsv(octagon()));
  EXPECT_EQ(rows[6][10], "interpolated");
  EXPECT_NE(rows[6][4], "");
  EXPECT_EQ(rows[7][0], "6");
  EXPECT_EQ(rows[7][1], "270");
  EXPECT_EQ(rows[7][10], "missing");
  for (const std::size_t cell : {2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 11U, 12U, 13U}) EXPECT_EQ(rows[7][cell], "") << cell;
  EXPECT_EQ(stationsCsv(Datum()), stationsCsv(octagon()).substr(0, stationsCsv(octagon()).find('\n') + 1));
}

TEST(Summary, IsShortAndSaysWhatCounts) {
  const std::string text = summary(octagon());
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 15);
  for (const char* part :
       {"partial", "1 of 8 stations are missing", "radius 10.000 m", "500001.500, 4000002.250",
        "6 measured, 1 interpolated, 1 missing", "annular_plate", "0.25 mm", "7.0 mm", "tilt", "antipodal"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
  Datum paper = octagon();
  paper.refined = {};
  EXPECT_NE(summary(paper).find("millimetres of bias"), std::string::npos);
}

TEST(Summary, DrawsTheElevationsWhereBlocksShow) {
  EXPECT_EQ(summary(octagon()).find("elevation"), std::string::npos);
  const std::string text = summary(octagon(), nothingSaid(), true);
  EXPECT_NE(text.find("elevation      ▁▂▃▄▅▆ █ from station 0 round\n"), std::string::npos) << text;
  EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 15);
  Datum many = octagon();
  const auto eight = many.stations;
  while (many.stations.size() < 360) many.stations.insert(many.stations.end(), eight.begin(), eight.end());
  EXPECT_NE(summary(many, nothingSaid(), true).find(" from station 0 round\n"),
            std::string::npos);  // not cut by the line's buffer
}

TEST(Summary, ALeanIsTowardsAnAzimuthOfTheStations) {
  Datum leaning = octagon();
  leaning.lean.slope = {0.0, 0.01}, leaning.lean.sigma = 1e-5;
  EXPECT_NE(summary(leaning).find("towards 90 deg"), std::string::npos);
  Provenance clockwise;
  clockwise.options.stations.clockwise = true;
  EXPECT_NE(summary(leaning, clockwise).find("towards 270 deg"), std::string::npos);
  EXPECT_NE(summary(leaning, clockwise).find("\nazimuths       clockwise from 0.0 deg counter-clockwise of +x\n"),
            std::string::npos);
  EXPECT_EQ(summary(leaning).find("azimuths"), std::string::npos);
}

TEST(Summary, OfNothingUsableSaysWhy) {
  Datum none;
  none.status = Status::NoTank;
  none.message = "nothing stands there";
  EXPECT_NE(summary(none).find("no_tank"), std::string::npos);
  EXPECT_NE(summary(none).find("nothing stands there"), std::string::npos);
  EXPECT_EQ(summary(none).find("radius"), std::string::npos);
}

TEST(WriteResults, AreReadBackInTheScansFrame) {
  const Folder folder;
  const Datum datum = octagon();
  writeResults(folder.path(""), datum, provenance());
  EXPECT_EQ(folder.entries(), 5U);
  EXPECT_EQ(readAll(folder.path("shell.csv")), "azimuth_deg,height,radius,deviation,sigma,n,offset\n");
  EXPECT_EQ(readAll(folder.path("datum.json")), datumJson(datum, provenance()));
  EXPECT_EQ(readAll(folder.path("stations.csv")), stationsCsv(datum));
  for (const auto& [name, wanted] :
       {std::pair<std::string, Points>{"datum_points.pcd", datum.edge_points}, {"datum_curve.pcd", {}}}) {
    Points read;
    const Scan scan = Scan::open({folder.path(name)});
    scan.forEachBlock([&](const Points& block) {
      for (const auto& p : block) read.push_back(p + scan.origin() - datum.origin);
    });
    if (name == "datum_curve.pcd") {
      ASSERT_EQ(read.size(), 7U);
      EXPECT_NEAR((read[6] - Eigen::Vector3d(datum.stations[7].x, datum.stations[7].y, 0.507)).norm(), 0.0, 1e-8);
    } else {
      ASSERT_EQ(read.size(), wanted.size());
      for (std::size_t i = 0; i < read.size(); ++i) EXPECT_NEAR((read[i] - wanted[i]).norm(), 0.0, 1e-8);
    }
  }
}

/// PCL 1.13 reads x, y and z of 8 bytes as zeros, and says nothing.
TEST(WriteResults, CloudsAreReadByPclNearTheOriginThatTheirHeadSays) {
  const Folder folder;
  const Datum datum = octagon();
  writeResults(folder.path(""), datum, provenance());
  for (const std::string name : {"datum_points.pcd", "datum_curve.pcd"}) {
    EXPECT_NE(readAll(folder.path(name)).find("# tank_datum: origin 500000 4000000 100\n"), std::string::npos);
    pcl::PointCloud<pcl::PointXYZ> cloud;
    ASSERT_EQ(pcl::io::loadPCDFile(folder.path(name), cloud), 0);
    Points full;
    const Scan scan = Scan::open({folder.path(name)});
    scan.relativeTo(Eigen::Vector3d::Zero()).forEachBlock([&](const Points& block) { full = block; });
    ASSERT_EQ(cloud.size(), full.size());
    ASSERT_GT(cloud.size(), 0U);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const Eigen::Vector3d from(500000, 4000000, 100);
      EXPECT_LE((cloud[i].getVector3fMap().cast<double>() + from - full[i]).cwiseAbs().maxCoeff(), 4e-6);
    }
  }
}

TEST(WriteResults, OfNothingUsableWritesNoClouds) {
  const Folder folder;
  writeResults(folder.path(""), Datum(), provenance());
  EXPECT_EQ(folder.entries(), 3U);
}

TEST(WriteResults, IntoNoFolderThrowsNamingThePath) {
  try {
    writeResults("/nowhere/at/all", octagon(), provenance());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::File);
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all"), std::string::npos);
  }
}

TEST(Summary, NamesTheThreeLargestLocalSettlementsOfATenthOfAMillimetre) {
  const auto text = [](const std::vector<double>& heights) {
    Datum datum = octagon();
    for (const double height : heights) datum.analysis.local_settlements.push_back({1.0, 0.1, height, 0.0001});
    return summary(datum);
  };
  const std::string five = text({0.001, -0.005, 0.002, 0.003, 0.0005});
  EXPECT_NE(five.find("local          -5.0 +- 0.2 mm"), std::string::npos) << five;
  EXPECT_NE(five.find("+2.0 +- 0.2 mm"), std::string::npos) << five;
  EXPECT_EQ(five.find("+1.0 +- 0.2 mm"), std::string::npos) << five;
  EXPECT_NE(five.find("; 2 more\n"), std::string::npos) << five;
  EXPECT_EQ(text({0.00004}).find("local"), std::string::npos);
  EXPECT_NE(text({0.00006}).find("local          +0.1 +- 0.2 mm"), std::string::npos);
}

TEST(Summary, DrawsFortyEightBlocks) {
  Datum many = octagon();
  many.stations = std::vector<Station>(360, many.stations.front());
  const std::string text = summary(many, nothingSaid(), true), block = "▅";
  std::size_t blocks = 0;
  for (std::size_t at = text.find(block); at != std::string::npos; at = text.find(block, at + block.size())) ++blocks;
  EXPECT_EQ(blocks, 48U) << text;
}

}  // namespace tank_datum::report_test
