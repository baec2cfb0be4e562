// The filter gives what extractDatum gives, for every type of point, and stands among PCL's own filters.

#include <gtest/gtest.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/voxel_grid.h>

#include <cmath>
#include <set>
#include <type_traits>

#include "support/pcl_clouds.h"
#include "tank_datum/pcl/datum_filter.h"

namespace tank_datum::datum_filter_chain_test {

using pcl_clouds::tankCloud;
using pcl_clouds::toTheEdge;

template <typename PointT>
class DatumFilterOf : public ::testing::Test {};
using PointTypes = ::testing::Types<pcl::PointXYZ, pcl::PointXYZI, pcl::PointXYZRGB, pcl::PointNormal>;
TYPED_TEST_SUITE(DatumFilterOf, PointTypes);

TYPED_TEST(DatumFilterOf, GivesTheDatumsEdgePointsAndTheDatumThatTheChainGives) {
  const bool whole = std::is_same_v<TypeParam, pcl::PointXYZ>;  // the defaults once, the others quicker
  const DatumOptions options = whole ? DatumOptions() : toTheEdge();
  const auto cloud = tankCloud<TypeParam>();
  DatumFilter<TypeParam> filter;
  filter.setOptions(options);
  filter.setInputCloud(cloud);
  pcl::PointCloud<TypeParam> edge;
  filter.filter(edge);

  Points points;
  for (const auto& p : *cloud) points.push_back(p.getVector3fMap().template cast<double>());
  const Datum expected = extractDatum(Scan::fromPoints(points), options);
  const Datum& datum = filter.getDatum();
  EXPECT_EQ(datum.status, Status::Ok) << datum.message;
  EXPECT_EQ(datum.edge_points, expected.edge_points);
  ASSERT_EQ(datum.stations.size(), 360U);
  for (std::size_t i = 0; i < 360; ++i) EXPECT_EQ(datum.stations[i].z, expected.stations[i].z) << i;
  ASSERT_EQ(edge.size(), datum.edge_points.size());
  std::set<std::vector<float>> wanted, got;
  for (const auto& p : expected.edge_points) {
    const Eigen::Vector3f at = (p + expected.origin).cast<float>();
    wanted.insert({at.x(), at.y(), at.z()});
  }
  for (const auto& p : edge) got.insert({p.x, p.y, p.z});
  EXPECT_EQ(got, wanted);
}

/// README's four lines, with points of a map's frame; without them the message says how coarse the cloud is.
TEST(DatumFilterFarAway, WantsAnOriginTakenOff) {
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const Eigen::Vector3d place(300'012.25, 5'000'034.5, 112.125);
  const Points made = made_clouds::tankPoints(Eigen::Vector3d::Zero());
  std::vector<double> x, y, z;
  for (const Eigen::Vector3d& p : made) {
    x.push_back(p.x() + place.x()), y.push_back(p.y() + place.y()), z.push_back(p.z() + place.z());
  }
  Cloud edge;
  DatumFilter<pcl::PointXYZ> filter;
  const auto cloud = std::make_shared<Cloud>();
  const Eigen::Vector3d from(std::floor(x[0]), std::floor(y[0]), std::floor(z[0]));
  for (std::size_t i = 0; i < made.size(); ++i) cloud->emplace_back(x[i] - from.x(), y[i] - from.y(), z[i] - from.z());
  filter.setInputCloud(cloud), filter.filter(edge);
  const Eigen::Vector3d origin = filter.getDatum().origin + from;

  EXPECT_EQ(filter.getDatum().status, Status::Ok);
  EXPECT_EQ(filter.getDatum().message.find("steps"), std::string::npos) << filter.getDatum().message;
  const Datum expected = extractDatum(Scan::fromPoints(made), DatumOptions());
  for (std::size_t i = 0; i < 360; ++i) {
    EXPECT_NEAR(filter.getDatum().stations[i].z + origin.z(), expected.stations[i].z + expected.origin.z() + place.z(),
                2e-5);
  }
  const auto far = std::make_shared<Cloud>();
  for (std::size_t i = 0; i < made.size(); ++i) far->emplace_back(x[i], y[i], z[i]);
  filter.setInputCloud(far), filter.filter(edge);
  EXPECT_NE(filter.getDatum().message.find("have steps of 500 mm here: store 8-byte ones"), std::string::npos)
      << filter.getDatum().message;
}

TEST(DatumFilterChain, StandsInAChainOfFilters) {
  using PointT = pcl::PointXYZI;
  const auto pass = std::make_shared<pcl::PassThrough<PointT>>();
  pass->setFilterFieldName("z");
  pass->setFilterLimits(0.0F, 1.5F);
  const auto voxel = std::make_shared<pcl::VoxelGrid<PointT>>();
  voxel->setLeafSize(0.03F, 0.03F, 0.03F);
  const auto datum = std::make_shared<DatumFilter<PointT>>();
  datum->setOptions(toTheEdge());
  const std::vector<pcl::Filter<PointT>::Ptr> chain = {pass, voxel, datum};

  auto cloud = tankCloud<PointT>();
  std::vector<std::size_t> sizes;
  for (const auto& filter : chain) {
    auto output = std::make_shared<pcl::PointCloud<PointT>>();
    filter->setInputCloud(cloud);
    filter->filter(*output);
    cloud = output;
    sizes.push_back(cloud->size());
  }
  EXPECT_GT(sizes[0], sizes[1]);
  EXPECT_GT(sizes[1], sizes[2]);
  EXPECT_GT(sizes[2], 500U);
  EXPECT_TRUE(datum->getDatum().usable()) << datum->getDatum().message;
  EXPECT_EQ(datum->getDatum().counts.points, sizes[1]);
  EXPECT_EQ(datum->getDatum().edge_points.size(), sizes[2]);
}
}  // namespace tank_datum::datum_filter_chain_test
