#include "tank_datum/pcl/pcl_stages.h"

#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>

#include <cmath>
#include <limits>

#include "support/pcl_clouds.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::pcl_stages_test {

using made_clouds::elevation;
using made_clouds::kRadius;
using made_clouds::kTurn;
using pcl_clouds::tankCloud;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

const Eigen::Vector3d kShift(40, -20, 7);

const Cloud::ConstPtr& tank() {
  static const Cloud::ConstPtr cloud = tankCloud<pcl::PointXYZ>(kShift);
  return cloud;
}

TEST(PclStages, ACloudIsAScanOfItsFinitePointsAndIndices) {
  auto cloud = std::make_shared<Cloud>();
  cloud->push_back({1, 2, 3});
  cloud->push_back({std::numeric_limits<float>::quiet_NaN(), 2, 3});
  cloud->push_back({4, 5, 6});
  Points seen;
  const auto see = [&](const Points& block) { seen.insert(seen.end(), block.begin(), block.end()); };
  const Scan all = scanOf<pcl::PointXYZ>(cloud);
  const ScanCounts counts = all.forEachBlock(see);
  EXPECT_EQ(counts.points, 3U);
  EXPECT_EQ(counts.invalid, 1U);
  EXPECT_EQ(all.origin(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(seen, (Points{{0, 0, 0}, {3, 3, 3}}));
  seen.clear();
  const Scan one = scanOf<pcl::PointXYZ>(cloud, std::make_shared<pcl::Indices>(pcl::Indices{2}));
  EXPECT_EQ(one.forEachBlock(see).points, 1U);
  EXPECT_EQ(one.origin(), Eigen::Vector3d(4, 5, 6));
}

TEST(PclStages, ACloudFarFromItsZeroHasAStep) {
  auto cloud = std::make_shared<Cloud>();
  cloud->push_back({300'000.0F, 20.0F, 3.0F});
  EXPECT_EQ(scanOf<pcl::PointXYZ>(cloud).coordinateStep(), 0.03125);
}

TEST(PclStages, APointThatIsNotFiniteIsNamed) {
  Cloud cloud = *tank();
  cloud[17].y = std::numeric_limits<float>::infinity();
  try {
    estimateNormals(cloud, NormalOptions());
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("point 17 of the cloud, not finite"), std::string::npos) << error.what();
  }
}

TEST(PclStages, NormalsKeepTheirNeighboursAndGoBackToPcl) {
  const Normals normals = estimateNormals(*tank(), NormalOptions(), 1);
  ASSERT_EQ(normals.size(), tank()->size());
  ASSERT_EQ(normals.neighbours.size(), 20 * tank()->size());
  for (std::size_t i = 0; i < normals.size(); i += 100) EXPECT_EQ(normals.neighbours[20 * i], static_cast<int>(i));
  const auto cloud = toPcl(normals);
  ASSERT_EQ(cloud.size(), normals.size());
  EXPECT_EQ(Eigen::Vector3f(cloud[5].getNormalVector3fMap()), normals.normals[5]);
}

TEST(PclStages, NormalsThroughATreeAreThoseOfTheOwnSearch) {
  pcl::search::KdTree<pcl::PointXYZ> unsorted(false);
  unsorted.setInputCloud(tank());
  NormalOptions options;
  options.k = 9;
  const Normals own = estimateNormals(*tank(), options), through = estimateNormals(*tank(), unsorted, options);
  EXPECT_EQ(through.k, 9);
  EXPECT_EQ(through.neighbours.size(), own.neighbours.size());
  std::size_t equal = 0;
  for (std::size_t i = 0; i < own.neighbours.size(); ++i) equal += own.neighbours[i] == through.neighbours[i];
  EXPECT_GT(equal, own.neighbours.size() * 99 / 100);  // all but those equally far in single precision
}

TEST(PclStages, NeighboursAreThoseAmongTheChosen) {
  Cloud row;
  for (int i = 0; i < 10; ++i) row.push_back({static_cast<float>(i), 0, 0});
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(row.makeShared());
  EXPECT_EQ(findNeighbours(tree, row, {9, 0, 4}, 2), (Neighbours{0, 2, 1, 2, 2, 1}));
  EXPECT_THROW(findNeighbours(tree, row, {9, 0, 4}, 4), Error);
}

TEST(PclStages, CandidatesAndEdgePointsAreTheCloudsOwn) {
  const Normals normals = estimateNormals(*tank(), NormalOptions());
  const auto candidates = growCandidates(normals, GrowingOptions());
  const EdgePoints edge = filterByCentre(*tank(), candidates, std::nullopt, CentreFilterOptions());
  EXPECT_NEAR((edge.circle.center - kShift.head<2>()).norm(), 0.0, 0.01);
  EXPECT_NEAR(edge.circle.radius, kRadius, 0.04);
  ASSERT_GT(edge.indices.size(), 1000U);
  for (std::size_t i = 0; i < edge.indices.size(); i += 50) {
    const auto& p = (*tank())[static_cast<std::size_t>(edge.indices[i])];
    EXPECT_NEAR(p.z - kShift.z(), elevation(edge.azimuths[i]), 0.15);  // no further than its neighbours reach
  }
}

TEST(PclStages, TanksAndRefinedStationsAreInTheCloudsFrame) {
  const std::vector<Tank> tanks = locateTanks<pcl::PointXYZ>(tank(), LocateOptions());
  ASSERT_EQ(tanks.size(), 1U);
  EXPECT_NEAR((tanks[0].circle.center - kShift.head<2>()).norm(), 0.0, 0.02);
  EXPECT_NEAR(tanks[0].foot(1.0), kShift.z() + elevation(1.0), 0.05);

  const auto [stations, refined] = refineStations<pcl::PointXYZ>(tank(), tanks[0], RefineOptions(), StationOptions());
  ASSERT_TRUE(refined.valid());
  EXPECT_NEAR((refined.circle.center - kShift.head<2>()).norm(), 0.0, 0.001);
  for (std::size_t i = 0; i < stations.size(); i += 10) {
    const double a = static_cast<double>(i) * kTurn / 360;
    ASSERT_NE(stations[i].flag, StationFlag::Missing);
    EXPECT_NEAR(stations[i].z, kShift.z() + elevation(a), 0.002) << i;
    EXPECT_NEAR(stations[i].x, kShift.x() + kRadius * std::cos(a), 0.005) << i;
    EXPECT_NEAR(stations[i].y, kShift.y() + kRadius * std::sin(a), 0.005) << i;
  }
}

}  // namespace tank_datum::pcl_stages_test
