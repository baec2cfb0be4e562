// Files by every one of PCL's own writers, read back.

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>

#include <cmath>
#include <fstream>

#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::pcd_pcl_files_test {

using pcd_files::Folder;

constexpr std::size_t kWidth = 37, kHeight = 29;  // a file of neither a page nor a block

float coordinate(std::size_t i, int axis) { return 0.125F * static_cast<float>(i) - 100.0F * static_cast<float>(axis); }

/// Organised; every seventh point was not seen.
template <typename PointT>
pcl::PointCloud<PointT> madeCloud() {
  pcl::PointCloud<PointT> cloud(kWidth, kHeight);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool seen = i % 7 != 0;
    cloud[i].getVector3fMap() =
        Eigen::Vector3f(coordinate(i, 0), coordinate(i, 1), seen ? coordinate(i, 2) : std::nanf(""));
  }
  cloud.is_dense = false;
  return cloud;
}

void expectTheCloud(const std::string& path) {
  Points points;
  const Scan scan = Scan::open({path});
  const ScanCounts counts = scan.forEachBlock([&](const Points& block) {
    for (const Eigen::Vector3d& p : block) points.push_back(p + scan.origin());
  });
  EXPECT_EQ(counts.points, kWidth * kHeight) << path;
  EXPECT_EQ(counts.invalid, (kWidth * kHeight + 6) / 7) << path;
  ASSERT_EQ(points.size(), counts.points - counts.invalid) << path;
  for (std::size_t i = 0, kept = 0; i < counts.points; ++i) {
    if (i % 7 == 0) continue;
    const Eigen::Vector3d expected(coordinate(i, 0), coordinate(i, 1), coordinate(i, 2));
    ASSERT_EQ(points[kept++], expected) << path << " row " << i;
  }
}

template <typename PointT>
class PclWriters : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

 private:
  Folder folder_;
};
using PointTypes = testing::Types<pcl::PointXYZ, pcl::PointXYZI, pcl::PointXYZRGB, pcl::PointXYZRGBNormal,
                                  pcl::PointXYZL, pcl::PointWithViewpoint>;
TYPED_TEST_SUITE(PclWriters, PointTypes);

TYPED_TEST(PclWriters, OfPointTypes) {
  const auto cloud = madeCloud<TypeParam>();
  pcl::Indices all(cloud.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  pcl::PCDWriter writer;
  ASSERT_EQ(writer.writeASCII(this->path("ascii"), cloud), 0);
  ASSERT_EQ(writer.writeASCII(this->path("ascii_indices"), cloud, all), 0);
  ASSERT_EQ(writer.writeBinary(this->path("binary"), cloud), 0);
  ASSERT_EQ(writer.writeBinary(this->path("binary_indices"), cloud, all), 0);
  ASSERT_EQ(writer.writeBinaryCompressed(this->path("compressed"), cloud), 0);
  for (const char* name : {"ascii", "ascii_indices", "binary", "binary_indices", "compressed"}) {
    expectTheCloud(this->path(name));
  }
}

TYPED_TEST(PclWriters, OfMessages) {
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(madeCloud<TypeParam>(), message);
  pcl::PCDWriter writer;
  const Eigen::Vector4f origin(1, 2, 3, 1);
  const Eigen::Quaternionf turned(0.5F, 0.5F, 0.5F, 0.5F);
  ASSERT_EQ(writer.writeASCII(this->path("ascii"), message, origin, turned), 0);
  ASSERT_EQ(writer.writeBinary(this->path("binary"), message, origin, turned), 0);
  ASSERT_EQ(writer.writeBinaryCompressed(this->path("compressed"), message, origin, turned), 0);
  {
    std::ofstream stream(this->path("stream"), std::ios::binary);
    ASSERT_EQ(writer.writeBinaryCompressed(stream, message, origin, turned), 0);
  }
  for (const char* name : {"ascii", "binary", "compressed", "stream"}) expectTheCloud(this->path(name));
}

TYPED_TEST(PclWriters, CutFilesAreRefusedAllTheSame) {
  pcl::PCLPointCloud2 message;
  pcl::toPCLPointCloud2(madeCloud<TypeParam>(), message);
  pcl::PCDWriter writer;
  writer.writeBinary(this->path("binary"), message);
  const std::size_t row = message.point_step, data = row * (kWidth * kHeight - 1);  // one row short, without its header
  std::filesystem::resize_file(this->path("binary"), data);
  EXPECT_NE(pcd_files::errorOf([&] { Scan::open({this->path("binary")}); }).find("POINTS of "), std::string::npos);
}

}  // namespace tank_datum::pcd_pcl_files_test
