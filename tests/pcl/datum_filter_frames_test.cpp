#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "core/units.h"
#include "support/pcl_clouds.h"
#include "tank_datum/core/error.h"
#include "tank_datum/pcl/datum_filter.h"

/// Clouds whose foot is not measured in the cloud's own frame: leaning, in other units, or turned upright first.
namespace tank_datum::datum_filter_frames_test {

using Cloud = pcl::PointCloud<pcl::PointNormal>;
using Filter = DatumFilter<pcl::PointNormal>;

const Points& tank() {
  static const Points points = made_clouds::tankPoints();
  return points;
}

/// The made tank, which leans by so much, in a unit of which a metre holds so many.
Cloud::Ptr leaning(double degrees, double per_metre = 1.0) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  Points points;
  for (const Eigen::Vector3d& p : tank()) points.push_back(per_metre * (turn * p));
  return pcl_clouds::cloudOf<pcl::PointNormal>(points);
}

DatumOptions options(bool level = false, double per_metre = 1.0) {
  DatumOptions given = pcl_clouds::toTheEdge();
  given.level = level;
  given.tank->radius *= per_metre;
  return given;
}

pcl::Indices edgeOf(Filter& filter, const Cloud::Ptr& cloud, const DatumOptions& given) {
  pcl::Indices edge;
  filter.setOptions(given);
  filter.setInputCloud(cloud);
  filter.filter(edge);
  return edge;
}

/// Of the filter's own search.
pcl::Indices plainEdge(const Cloud::Ptr& cloud, const DatumOptions& given = options()) {
  Filter filter;
  return edgeOf(filter, cloud, given);
}

pcl::Indices searchedEdge(const Cloud::Ptr& cloud, const DatumOptions& given = options()) {
  Filter filter;
  filter.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  return edgeOf(filter, cloud, given);
}

/// How many of the indices both have, of as many as the first has.
double common(const pcl::Indices& a, const pcl::Indices& b) {
  pcl::Indices both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return static_cast<double>(both.size()) / static_cast<double>(a.size());
}

TEST(DatumFilterFrames, OfALeaningTankThePointsAreTheCloudsOwn) {
  const pcl::Indices upright = plainEdge(leaning(0.0));
  ASSERT_GT(upright.size(), 3000U);
  for (const double degrees : {0.4, 1.0}) {
    const pcl::Indices edge = plainEdge(leaning(degrees));
    EXPECT_GT(common(upright, edge), 0.95) << degrees;
    EXPECT_GT(common(edge, upright), 0.95) << degrees;
    EXPECT_EQ(searchedEdge(leaning(degrees)), edge) << degrees;
  }
}

TEST(DatumFilterFrames, SoTheyAreInOtherUnits) {
  const pcl::Indices metres = plainEdge(leaning(0.0));
  for (const double per_metre : {1000.0, 1.0 / 0.0254, 0.01}) {
    const DatumOptions given = options(false, per_metre);
    const Cloud::Ptr cloud = leaning(0.0, per_metre);
    const pcl::Indices edge = plainEdge(cloud, given);
    EXPECT_GT(common(metres, edge), 0.7) << per_metre;  // of a ring as wide for its radius
    EXPECT_GT(common(searchedEdge(cloud, given), edge), 0.99) << per_metre;
  }
}

TEST(DatumFilterFrames, SoTheyAreOfAScanTurnedUpright) {
  const Cloud::Ptr cloud = leaning(1.0);
  const pcl::Indices edge = plainEdge(cloud, options(true));
  EXPECT_GT(common(plainEdge(leaning(0.0)), edge), 0.95);
  EXPECT_EQ(searchedEdge(cloud, options(true)), edge);
}

TEST(DatumFilterFrames, TheCloudsOwnNormalsServeThereToo) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.0 * kDegree, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Cloud::Ptr cloud = leaning(1.0);
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    const Eigen::Vector3d& p = tank()[i];
    const bool is_wall = p.head<2>().norm() < made_clouds::kRadius + 0.005;
    const Eigen::Vector3d outwards(p.x(), p.y(), 0.0);
    const Eigen::Vector3d normal = is_wall ? outwards.normalized() : Eigen::Vector3d::UnitZ();
    (*cloud)[i].getNormalVector3fMap() = (1e30 * (turn * normal)).cast<float>();
  }
  for (const bool level : {false, true}) {
    Filter filter;
    filter.setUseCloudNormals(true);
    const pcl::Indices edge = edgeOf(filter, cloud, options(level));
    ASSERT_GT(edge.size(), 1000U) << level;
    for (const pcl::index_t i : edge) {  // exact normals grow at the foot alone
      const Eigen::Vector3d& p = tank()[static_cast<std::size_t>(i)];
      EXPECT_NEAR(p.z(), made_clouds::elevation(std::atan2(p.y(), p.x())), 0.2) << level;
    }
  }
}

TEST(DatumFilterFrames, IndicesMayBeNarrowedInPlace) {
  const Cloud::Ptr cloud = leaning(0.0);
  auto indices = std::make_shared<pcl::Indices>();
  for (pcl::index_t i = 0; i < static_cast<pcl::index_t>(cloud->size()); ++i) indices->push_back(i);
  Filter filter;
  filter.setOptions(options());
  filter.setInputCloud(cloud);
  filter.setIndices(indices);
  filter.filter(*indices);
  EXPECT_EQ(*indices, plainEdge(cloud));
}

TEST(DatumFilterFrames, IndicesInPlaceSurviveARefusal) {
  const Cloud::Ptr cloud = leaning(0.0);
  auto indices = std::make_shared<pcl::Indices>(pcl::Indices{1, 2, static_cast<pcl::index_t>(cloud->size())});
  Filter filter;
  filter.setOptions(options());
  filter.setInputCloud(cloud);
  filter.setIndices(indices);
  EXPECT_THROW(filter.filter(*indices), Error);
  EXPECT_EQ(indices->size(), 3U);
}

TEST(DatumFilterFrames, ACloudThatIsFilledAnewIsSearchedAnew) {
  const Cloud::Ptr cloud = leaning(0.0);
  Filter filter;
  filter.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointNormal>>());
  const pcl::Indices before = edgeOf(filter, cloud, options());
  std::reverse(cloud->begin(), cloud->end());
  filter.setInputCloud(cloud);
  filter.setSearchMethod(filter.getSearchMethod());
  pcl::Indices after = edgeOf(filter, cloud, options());
  for (pcl::index_t& i : after) i = static_cast<pcl::index_t>(cloud->size()) - 1 - i;
  std::reverse(after.begin(), after.end());
  EXPECT_EQ(after, before);
}

}  // namespace tank_datum::datum_filter_frames_test
