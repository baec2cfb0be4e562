#include <gtest/gtest.h>

#include "support/made_datums.h"
#include "support/pcd_files.h"
#include "support/refused.h"
#include "view/stations_file.h"

namespace tank_datum::view::view_stations_file_test {

using made_datums::octagon;
using pcd_files::Folder;

std::string refusalOf(const std::string& path) {
  return refusalOf(Error::Kind::File, [&] { readStations(path, Eigen::Vector3d::Zero()); });
}

TEST(ReadStations, GivesBackWhatWasWritten) {
  const Folder folder;
  const Datum datum = octagon();
  const auto read = readStations(folder.file("stations.csv", stationsCsv(datum)), datum.origin);
  ASSERT_EQ(read.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    const Station &a = read[i], &b = datum.stations[i];
    EXPECT_EQ(a.flag, b.flag);
    EXPECT_NEAR(a.azimuth, b.azimuth, 1e-9);
    if (i == 6) {
      EXPECT_TRUE(std::isnan(a.z) && std::isnan(a.u));
      continue;
    }
    EXPECT_NEAR((Eigen::Vector3d(a.x, a.y, a.z) - Eigen::Vector3d(b.x, b.y, b.z)).norm(), 0.0, 1e-8);
    EXPECT_NEAR(a.z_paper, b.z_paper, 1e-9);
    EXPECT_NEAR(a.z_tilt, b.z_tilt, 1e-9);
    EXPECT_EQ(a.sigma_z, b.sigma_z);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(a.sigma_radius, b.sigma_radius);
    EXPECT_EQ(a.u, b.u);
  }
}

TEST(ReadStations, NamesWhatIsWrong) {
  const Folder folder;
  EXPECT_NE(refusalOf(folder.path("none.csv")).find("none.csv"), std::string::npos);
  EXPECT_NE(refusalOf(folder.file("a.csv", "station,azimuth_deg\n0,0\n")).find("no x"), std::string::npos);
  std::string csv = stationsCsv(octagon());
  csv.replace(csv.find("0.00025"), 7, "0.00o25");
  const std::string refusal = refusalOf(folder.file("b.csv", csv));
  EXPECT_NE(refusal.find("sigma_z in "), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("line 2"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("0.00o25"), std::string::npos) << refusal;
}

}  // namespace tank_datum::view::view_stations_file_test
