#include <gtest/gtest.h>
#include <pcl/register_point_struct.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <atomic>
#include <limits>
#include <numeric>

#include "support/pcl_clouds.h"
#include "tank_datum/core/error.h"
#include "tank_datum/pcl/datum_filter.h"
#include "tank_datum/pcl/impl/datum_filter.hpp"

/// A point type that the library has not been compiled for.
struct EIGEN_ALIGN16 ReflectancePoint {
  PCL_ADD_POINT4D;
  float reflectance;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(ReflectancePoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float, reflectance, reflectance))

namespace tank_datum::datum_filter_search_test {

using made_clouds::kRadius;
using pcl_clouds::tankCloud;
using pcl_clouds::toTheEdge;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Filter = DatumFilter<pcl::PointXYZ>;

/// A kd-tree that counts what is asked of it.
class CountingTree : public pcl::search::KdTree<pcl::PointXYZ> {
 public:
  int built = 0;
  mutable std::atomic<std::size_t> asked{0};

  void setInputCloud(const PointCloudConstPtr& cloud, const pcl::IndicesConstPtr& indices = nullptr) override {
    ++built;
    KdTree::setInputCloud(cloud, indices);
  }
  int nearestKSearch(const pcl::PointXYZ& point, int k, pcl::Indices& found,
                     std::vector<float>& distances) const override {
    ++asked;
    return KdTree::nearestKSearch(point, k, found, distances);
  }
};

pcl::Indices run(Filter& filter) {
  pcl::Indices edge;
  filter.filter(edge);
  return edge;
}

struct SearchedTank : ::testing::Test {
  Cloud::Ptr cloud = tankCloud<pcl::PointXYZ>();
  std::shared_ptr<CountingTree> tree = std::make_shared<CountingTree>();
  Filter filter;
  pcl::Indices expected;  ///< by the chain's own search

  SearchedTank() {
    filter.setOptions(toTheEdge());
    filter.setInputCloud(cloud);
    expected = run(filter);
    filter.setSearchMethod(tree);
  }
};

TEST_F(SearchedTank, HasTheSameEdgeAndTheTreeIsAskedAndNotRebuilt) {
  ASSERT_GT(expected.size(), 1000U);
  tree->setInputCloud(cloud);
  EXPECT_EQ(run(filter), expected);
  EXPECT_EQ(tree->built, 1);
  EXPECT_GT(tree->asked.load(), expected.size());
  EXPECT_EQ(run(filter), expected);
  EXPECT_EQ(tree->built, 1);
}

TEST_F(SearchedTank, ATreeOfAnotherCloudOrOfSomeOfItsPointsIsBuiltAnew) {
  EXPECT_EQ(run(filter), expected);
  EXPECT_EQ(tree->built, 1);
  EXPECT_EQ(tree->getInputCloud(), cloud);
  tree->setInputCloud(cloud, std::make_shared<pcl::Indices>(pcl::Indices{1, 2, 3}));
  EXPECT_EQ(run(filter), expected);
  EXPECT_EQ(tree->built, 3);
}

TEST_F(SearchedTank, ATreeOverTheFiltersOwnIndicesIsReused) {
  auto most = std::make_shared<pcl::Indices>(cloud->size() - 100);
  std::iota(most->begin(), most->end(), 100);
  filter.setIndices(most);
  filter.setSearchMethod(nullptr);
  const pcl::Indices without_tree = run(filter);
  tree->setInputCloud(cloud, std::make_shared<pcl::Indices>(*most));
  filter.setSearchMethod(tree);
  EXPECT_EQ(run(filter), without_tree);
  EXPECT_EQ(tree->built, 1);
}

TEST_F(SearchedTank, WhoseRingIsThinnedHasTheSameEdgeThroughATreeOfAllPoints) {
  DatumOptions options = toTheEdge();
  options.crop.search_points = 6000;
  filter.setOptions(options);
  filter.setSearchMethod(nullptr);
  const pcl::Indices thinned = run(filter);
  EXPECT_GT(thinned.size(), 100U);
  EXPECT_LT(thinned.size(), expected.size());
  filter.setSearchMethod(tree);
  EXPECT_EQ(run(filter), thinned);
}

TEST_F(SearchedTank, WithPointsThatAreNotFiniteHasTheSameEdgeThroughATree) {
  for (std::size_t i = 0; i < cloud->size(); i += 3) (*cloud)[i].x = std::numeric_limits<float>::quiet_NaN();
  cloud->is_dense = false;
  filter.setSearchMethod(nullptr);
  const pcl::Indices own = run(filter);
  EXPECT_GT(own.size(), 500U);
  filter.setSearchMethod(tree);
  EXPECT_EQ(run(filter), own);
}

TEST_F(SearchedTank, AnySearchOfPclWillDo) {
  filter.setSearchMethod(std::make_shared<pcl::search::Octree<pcl::PointXYZ>>(0.05));
  EXPECT_EQ(run(filter), expected);
}

/// Finds at most five neighbours.
class ShortSighted : public CountingTree {
 public:
  int nearestKSearch(const pcl::PointXYZ& point, int, pcl::Indices& found,
                     std::vector<float>& distances) const override {
    return CountingTree::nearestKSearch(point, 5, found, distances);
  }
};

TEST_F(SearchedTank, ASearchThatFindsTooFewNeighboursIsRefused) {
  filter.setSearchMethod(std::make_shared<ShortSighted>());
  try {
    run(filter);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "normals: neighbours found by the search method, 5, expected 20");
  }
  EXPECT_EQ(filter.getDatum().status, Status::NotRun);
}

/// The made tank with the normals of a plain cylinder, so that no crease shows in them.
pcl::PointCloud<pcl::PointNormal>::Ptr creaselessTank() {
  const auto cloud = tankCloud<pcl::PointNormal>();
  for (auto& p : *cloud)
    p.getNormalVector3fMap() = Eigen::Vector3f(0.01F * p.x, 0.01F * p.y, 0.0F);  // of no unit length
  return cloud;
}

struct TankWithNormals : ::testing::Test {
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud = creaselessTank();
  DatumFilter<pcl::PointNormal> filter;

  std::size_t edge(bool use_cloud_normals) {
    filter.setOptions(toTheEdge());
    filter.setInputCloud(cloud);
    filter.setUseCloudNormals(use_cloud_normals);
    pcl::Indices found;
    filter.filter(found);
    return found.size();
  }
};

TEST_F(TankWithNormals, TheyAreUsedWhenAsked) {
  EXPECT_GT(edge(false), 1000U);
  EXPECT_EQ(edge(true), 0U);
  filter.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  EXPECT_EQ(edge(true), 0U);
  for (auto& p : *cloud) {
    if (std::hypot(p.x, p.y) > kRadius + 0.01F) p.getNormalVector3fMap() = Eigen::Vector3f(0, 0, 3);
  }
  EXPECT_GT(edge(true), 1000U);
}

TEST_F(TankWithNormals, UnknownOnesAreEstimated) {
  const std::size_t estimated = edge(false);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const float nothing = i % 2 == 0 ? 0.0F : std::numeric_limits<float>::quiet_NaN();
    (*cloud)[i].getNormalVector3fMap() = Eigen::Vector3f::Constant(nothing);
  }
  EXPECT_EQ(edge(true), estimated);
}

TEST(DatumFilterNormals, OfAPointTypeWithoutThemAreRefused) {
  Filter filter;
  EXPECT_THROW(filter.setUseCloudNormals(true), Error);
  EXPECT_FALSE(filter.getUseCloudNormals());
  EXPECT_NO_THROW(filter.setUseCloudNormals(false));
}

TEST(DatumFilterOfAnyPointType, WorksWithOneHeader) {
  const auto cloud = tankCloud<ReflectancePoint>();
  (*cloud)[0].reflectance = 1.0F;
  DatumFilter<ReflectancePoint> filter;
  filter.setOptions(toTheEdge());
  filter.setInputCloud(cloud);
  pcl::PointCloud<ReflectancePoint> edge;
  filter.filter(edge);
  EXPECT_GT(edge.size(), 1000U);
  EXPECT_EQ(edge.size(), filter.getDatum().edge_points.size());
}

}  // namespace tank_datum::datum_filter_search_test
