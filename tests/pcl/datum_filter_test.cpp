#include "tank_datum/pcl/datum_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "support/pcl_clouds.h"
#include "tank_datum/core/error.h"

namespace tank_datum::datum_filter_test {

using made_clouds::kRadius;
using pcl_clouds::tankCloud;
using pcl_clouds::toTheEdge;
using Cloud = pcl::PointCloud<pcl::PointXYZI>;
using Filter = DatumFilter<pcl::PointXYZI>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The made tank; a point's intensity is its index.
Cloud::Ptr numberedTank() {
  Cloud::Ptr cloud = tankCloud<pcl::PointXYZI>();
  for (std::size_t i = 0; i < cloud->size(); ++i) (*cloud)[i].intensity = static_cast<float>(i);
  return cloud;
}

Filter filterOf(const Cloud::ConstPtr& cloud, bool extract_removed = false) {
  Filter filter(extract_removed);
  filter.setOptions(toTheEdge());
  filter.setInputCloud(cloud);
  return filter;
}

pcl::Indices indicesOf(Filter filter) {
  pcl::Indices indices;
  filter.filter(indices);
  return indices;
}

/// Of the whole made tank, made once.
const pcl::Indices& edgeIndices() {
  static const pcl::Indices edge = indicesOf(filterOf(numberedTank()));
  return edge;
}

pcl::Indices without(std::size_t count, const pcl::Indices& some) {
  pcl::Indices rest;
  const std::set<pcl::index_t> left_out(some.begin(), some.end());
  for (pcl::index_t i = 0; i < static_cast<pcl::index_t>(count); ++i) {
    if (left_out.count(i) == 0) rest.push_back(i);
  }
  return rest;
}

pcl::Indices numbersOf(const Cloud& cloud) {
  pcl::Indices numbers;
  for (const auto& p : cloud) numbers.push_back(static_cast<pcl::index_t>(p.intensity));
  return numbers;
}

TEST(DatumFilter, KeepsTheCloudsOrderAndItsFields) {
  const auto cloud = numberedTank();
  Cloud edge;
  Filter filter = filterOf(cloud);
  filter.filter(edge);
  EXPECT_GT(edge.size(), 1000U);
  EXPECT_TRUE(std::is_sorted(edgeIndices().begin(), edgeIndices().end()));
  EXPECT_EQ(numbersOf(edge), edgeIndices());
  EXPECT_EQ(edge.width, edge.size());
  EXPECT_EQ(edge.height, 1U);
  EXPECT_TRUE(edge.is_dense);
  for (const auto& p : edge) EXPECT_NEAR(std::hypot(p.x, p.y), kRadius, 0.11);
}

TEST(DatumFilter, MayPutItsOutputWhereItsInputWas) {
  const auto cloud = numberedTank();
  Filter filter = filterOf(cloud);
  filter.filter(*cloud);
  EXPECT_EQ(numbersOf(*cloud), edgeIndices());
}

TEST(DatumFilter, NegativeGivesTheOthers) {
  const auto cloud = numberedTank();
  Filter filter = filterOf(cloud);
  filter.setNegative(true);
  Cloud others;
  filter.filter(others);
  EXPECT_EQ(numbersOf(others), without(cloud->size(), edgeIndices()));
}

TEST(DatumFilter, TellsTheRemovedIndicesWhenAsked) {
  const auto cloud = numberedTank();
  for (const bool negative : {false, true}) {
    Filter filter = filterOf(cloud, true);
    filter.setNegative(negative);
    pcl::Indices kept;
    filter.filter(kept);
    EXPECT_EQ(*filter.getRemovedIndices(), without(cloud->size(), kept));
  }
  Filter silent = filterOf(cloud);
  pcl::Indices kept;
  silent.filter(kept);
  EXPECT_TRUE(silent.getRemovedIndices()->empty());
}

TEST(DatumFilter, PointsThatAreNotFiniteAreRemovedEitherWay) {
  const auto cloud = numberedTank();
  const pcl::index_t at = edgeIndices()[10];
  (*cloud)[static_cast<std::size_t>(at)].z = kNaN;
  (*cloud)[0].x = std::numeric_limits<float>::infinity();
  cloud->is_dense = false;
  for (const bool negative : {false, true}) {
    Filter filter = filterOf(cloud, true);
    filter.setNegative(negative);
    Cloud kept;
    filter.filter(kept);
    EXPECT_TRUE(kept.is_dense);
    EXPECT_GT(kept.size(), 1000U);
    const pcl::Indices numbers = numbersOf(kept), removed = *filter.getRemovedIndices();
    EXPECT_EQ(removed, without(cloud->size(), numbers));
    EXPECT_EQ(removed.front(), 0);
    EXPECT_TRUE(std::binary_search(removed.begin(), removed.end(), at));
    EXPECT_EQ(filter.getDatum().counts.invalid, 2U);
    EXPECT_EQ(filter.getDatum().counts.points, cloud->size());
  }
}

TEST(DatumFilter, KeepsAnOrganizedCloudsShapeWithTheUsersValue) {
  const auto cloud = numberedTank();
  cloud->resize(cloud->size() / 4 * 4);
  cloud->width = static_cast<std::uint32_t>(cloud->size() / 4);
  cloud->height = 4;
  const pcl::Indices edge = indicesOf(filterOf(cloud));
  ASSERT_GT(edge.size(), 1000U);
  for (const float value : {kNaN, -7.0F}) {
    Filter filter = filterOf(cloud);
    filter.setKeepOrganized(true);
    filter.setUserFilterValue(value);
    Cloud output;
    testing::internal::CaptureStderr();
    filter.filter(output);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    ASSERT_EQ(output.size(), cloud->size());
    EXPECT_EQ(output.width, cloud->width);
    EXPECT_EQ(output.height, 4U);
    EXPECT_EQ(output.is_dense, std::isfinite(value));
    EXPECT_EQ(*filter.getRemovedIndices(), without(cloud->size(), edge));
    for (std::size_t i = 0; i < output.size(); ++i) {
      const bool is_edge = std::binary_search(edge.begin(), edge.end(), static_cast<pcl::index_t>(i));
      const float expected = is_edge ? (*cloud)[i].z : value;
      EXPECT_TRUE(output[i].z == expected || (std::isnan(output[i].z) && std::isnan(expected))) << i;
      EXPECT_EQ(output[i].intensity, (*cloud)[i].intensity);
    }
  }
}

TEST(DatumFilter, SeesOnlyThePointsOfItsIndicesAndKeepsTheirOrder) {
  const auto cloud = numberedTank();
  auto half = std::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    if ((*cloud)[i].y > 0) half->push_back(static_cast<pcl::index_t>(i));
  }
  std::shuffle(half->begin(), half->end(), std::mt19937(4));
  Filter filter = filterOf(cloud, true);
  filter.setIndices(half);
  pcl::Indices edge;
  filter.filter(edge);
  EXPECT_EQ(filter.getDatum().status, Status::Partial) << filter.getDatum().message;
  EXPECT_EQ(filter.getDatum().counts.points, half->size());
  EXPECT_GT(edge.size(), 500U);

  pcl::Indices merged;  // the kept and the removed ones, taken in the order of the indices, are the indices
  auto kept = edge.begin();
  auto removed = filter.getRemovedIndices()->begin();
  for (const pcl::index_t i : *half) {
    const bool from_kept = kept != edge.end() && *kept == i;
    merged.push_back(from_kept ? *kept++ : *removed++);
  }
  EXPECT_EQ(merged, *half);
  EXPECT_EQ(edge.size() + filter.getRemovedIndices()->size(), half->size());
}

TEST(DatumFilter, AnIndexGivenTwiceIsOnePointOfTheScan) {
  const auto cloud = numberedTank();
  auto twice = std::make_shared<pcl::Indices>(cloud->size());
  std::iota(twice->begin(), twice->end(), 0);
  twice->insert(twice->end(), edgeIndices().begin(), edgeIndices().end());
  Filter filter = filterOf(cloud);
  filter.setIndices(twice);
  pcl::Indices edge, expected = edgeIndices();
  filter.filter(edge);
  expected.insert(expected.end(), edgeIndices().begin(), edgeIndices().end());
  EXPECT_EQ(edge, expected);
  EXPECT_EQ(filter.getDatum().counts.points, cloud->size());
}

TEST(DatumFilter, OptionsReachTheChain) {
  Filter filter = filterOf(numberedTank());
  DatumOptions options = toTheEdge();
  options.growing.angle = 1.2;
  filter.setOptions(options);
  EXPECT_EQ(filter.getOptions().growing.angle, 1.2);
  pcl::Indices edge;
  filter.filter(edge);
  EXPECT_LT(edge.size(), edgeIndices().size());
}

}  // namespace tank_datum::datum_filter_test
