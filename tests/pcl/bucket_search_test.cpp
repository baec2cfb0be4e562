#include "tank_datum/pcl/bucket_search.h"

#include <gtest/gtest.h>
#include <pcl/search/kdtree.h>

#include <limits>

#include "support/pcl_clouds.h"
#include "tank_datum/pcl/datum_filter.h"

namespace tank_datum::bucket_search_test {

using pcl_clouds::tankCloud;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Answer {
  pcl::Indices indices;
  std::vector<float> distances;
  bool operator==(const Answer& other) const { return indices == other.indices && distances == other.distances; }
};

Answer nearest(const pcl::search::Search<pcl::PointXYZ>& search, const pcl::PointXYZ& point, int k) {
  Answer answer;
  const int count = search.nearestKSearch(point, k, answer.indices, answer.distances);
  EXPECT_EQ(static_cast<std::size_t>(count), answer.indices.size());
  return answer;
}

Answer within(const pcl::search::Search<pcl::PointXYZ>& search, const pcl::PointXYZ& point, double radius,
              unsigned int most = 0) {
  Answer answer;
  const int count = search.radiusSearch(point, radius, answer.indices, answer.distances, most);
  EXPECT_EQ(static_cast<std::size_t>(count), answer.indices.size());
  return answer;
}

struct BucketSearchOfATank : ::testing::Test {
  Cloud::Ptr cloud = tankCloud<pcl::PointXYZ>();
  BucketSearch<pcl::PointXYZ> buckets;
  pcl::search::KdTree<pcl::PointXYZ> flann;
  const float kNan = std::numeric_limits<float>::quiet_NaN();
};

TEST_F(BucketSearchOfATank, AnswersAsThatOfPcl) {
  (*cloud)[17].x = kNan;
  buckets.setInputCloud(cloud);
  flann.setInputCloud(cloud);
  EXPECT_EQ(buckets.getInputCloud(), cloud);
  for (std::size_t i = 0; i < cloud->size(); i += 997) {
    EXPECT_TRUE(nearest(buckets, (*cloud)[i], 12) == nearest(flann, (*cloud)[i], 12)) << i;
    EXPECT_TRUE(within(buckets, (*cloud)[i], 0.15) == within(flann, (*cloud)[i], 0.15)) << i;
    EXPECT_GT(within(buckets, (*cloud)[i], 0.15).indices.size(), 5U);
    EXPECT_TRUE(within(buckets, (*cloud)[i], 0.15, 5) == nearest(flann, (*cloud)[i], 5)) << i;
  }
}

TEST_F(BucketSearchOfATank, FindsAmongTheChosenPointsOnly) {
  const auto chosen = std::make_shared<pcl::Indices>();
  for (int i = 0; i < 2000; ++i) chosen->push_back(3 * i + 1);
  (*cloud)[4].z = kNan;
  buckets.setInputCloud(cloud, chosen);
  flann.setInputCloud(cloud, chosen);
  EXPECT_EQ(buckets.getIndices(), chosen);
  EXPECT_TRUE(nearest(buckets, (*cloud)[0], 30) == nearest(flann, (*cloud)[0], 30));
  EXPECT_EQ(nearest(buckets, (*cloud)[0], 5000).indices.size(), 1999U);
}

TEST_F(BucketSearchOfATank, ServesTheFilterAsItsOwnSearchDoes) {
  const auto edge = [&](const DatumFilter<pcl::PointXYZ>::SearcherPtr& search) {
    DatumFilter<pcl::PointXYZ> filter;
    filter.setOptions(pcl_clouds::toTheEdge());
    filter.setInputCloud(cloud);
    filter.setSearchMethod(search);
    pcl::Indices found;
    filter.filter(found);
    return found;
  };
  const auto own = edge(nullptr);
  EXPECT_GT(own.size(), 1000U);
  EXPECT_EQ(edge(std::make_shared<BucketSearch<pcl::PointXYZ>>()), own);
}

}  // namespace tank_datum::bucket_search_test
