// Files of other programs, from the folder TANK_DATUM_DATA; counts and bounds by independent readers (NOTE.txt there).

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::pcd_real_files_test {

struct RealFile {
  const char* path;
  std::uint64_t points, finite;
  Eigen::Vector3d min, max;  // to 3 decimals
};

void PrintTo(const RealFile& file, std::ostream* out) { *out << file.path; }

/// The file's name; a test's name holds letters, digits and underscores alone.
std::string nameOf(const testing::TestParamInfo<RealFile>& info) {
  std::string name = std::filesystem::path(info.param.path).stem().string();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class PcdRealFile : public testing::TestWithParam<RealFile> {};

const RealFile kFiles[] = {
    {"formats/pcd/pcl_bun0_ascii.pcd", 397, 397, {-0.094, 0.037, -0.055}, {0.06, 0.184, 0.058}},
    {"formats/pcd/pcl_car6.pcd", 10031, 10031, {-40.169, -68.56, -6.99}, {-33.95, -61.88, -5.43}},
    {"formats/pcd/pcl_colored_cloud.pcd", 1000, 1000, {-0.887, -0.651, 0.882}, {0.489, -0.375, 1.532}},
    {"formats/pcd/pcl_lamppost.pcd", 1771, 1771, {-11.172, -0.375, -5.448}, {-9.766, 0.594, 0.467}},
    {"formats/pcd/pcl_milk.pcd", 13704, 13704, {-0.14, -0.264, 0.714}, {0.014, -0.012, 0.891}},
    {"formats/pcd/pcl_noisy_slice_displaced.pcd", 3782, 3782, {0.943, 0.69, 1.243}, {1.056, 0.8, 1.312}},
    {"formats/pcd/pdal_autzen-utm.pcd", 1065, 1065, {493994.87, 4877429.62, 123.93}, {494993.68, 4878817.02, 178.73}},
    {"formats/pcd/pdal_utm17_comma.pcd", 10, 10, {289814.15, 4320978.61, 170.58}, {289818.5, 4320980.59, 170.76}},
    {"formats/pcd/pdal_utm17_space.pcd", 10, 10, {289814.15, 4320978.61, 170.58}, {289818.5, 4320980.59, 170.76}},
    {"formats/pcd/pdal_utm17_tab.pcd", 10, 10, {289814.15, 4320978.61, 170.58}, {289818.5, 4320980.59, 170.76}},
    {"cylinders_on_plane/learn44.pcd", 307200, 174620, {-0.56, -0.416, 0.632}, {0.388, 0.293, 1.673}},
};
INSTANTIATE_TEST_SUITE_P(All, PcdRealFile, testing::ValuesIn(kFiles), nameOf);

std::string dataFile(const std::string& path) { return pcd_files::dataFolder() + "/" + path; }

TEST_P(PcdRealFile, CountsAndBounds) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const RealFile& file = GetParam();
  const Scan scan = Scan::open({dataFile(file.path)});
  EXPECT_EQ(scan.size(), file.points);
  Eigen::Vector3d min = Eigen::Vector3d::Constant(1e300), max = -min;
  const ScanCounts counts = scan.forEachBlock([&](const Points& block) {
    for (const Eigen::Vector3d& p : block) {
      min = min.cwiseMin(p + scan.origin());
      max = max.cwiseMax(p + scan.origin());
    }
  });
  EXPECT_EQ(counts.points, file.points);
  EXPECT_EQ(counts.points - counts.invalid, file.finite);
  EXPECT_LT((min - file.min).cwiseAbs().maxCoeff(), 5.01e-4) << min.transpose();
  EXPECT_LT((max - file.max).cwiseAbs().maxCoeff(), 5.01e-4) << max.transpose();
}

TEST(PcdRealFiles, StereoScene) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const ScanCounts counts =
      Scan::open({dataFile("cylinders_on_plane/table_scene_mug_stereo_textured.pcd")}).forEachBlock([](const Points&) {
      });
  EXPECT_EQ(counts.points, 307200U);
  EXPECT_EQ(counts.points - counts.invalid, 209280U);
}

/// Written by PCL, which fills the file up to a page.
TEST(PcdRealFiles, Padded) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const auto finite = [](const std::string& name) {
    const ScanCounts counts = Scan::open({dataFile("padded/" + name)}).forEachBlock([](const Points&) {});
    EXPECT_EQ(counts.points, Scan::open({dataFile("padded/" + name)}).size());
    return counts.points - counts.invalid;
  };
  for (const char* name : {"sample_pc2_ascii.pcd", "sample_pc2_binary.pcd", "sample_pc2_bc.pcd"}) {
    EXPECT_EQ(finite(name), 25963U) << name;
  }
  EXPECT_EQ(finite("zaghetto.pcd"), 59750U);
}

TEST(PcdRealFiles, BadOnes) {
  if (pcd_files::dataFolder().empty()) GTEST_SKIP() << "TANK_DATUM_DATA is not set";
  const auto expectRefusal = [](const std::string& path, const std::string& part) {
    const std::string message =
        pcd_files::errorOf([&] { Scan::open({dataFile(path)}).forEachBlock([](const Points&) {}); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expectRefusal("bad/derived/empty_0bytes.pcd", "an empty file");
  expectRefusal("bad/derived/pcd_no_DATA_line.pcd", "header line 11 of ");
  expectRefusal("bad/derived/pcd_ascii_fewer_rows_than_POINTS.pcd", "89 whole ones, expected 397 (POINTS)");
  expectRefusal("bad/derived/pcd_ascii_nonnumeric_row.pcd", "row 40 of ");
  expectRefusal("bad/derived/pcd_bc_truncated_200k.pcd", "compressed size of ");
}

}  // namespace tank_datum::pcd_real_files_test
