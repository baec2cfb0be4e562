#include "search/bucket_tree.h"

#include <gtest/gtest.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cstring>
#include <mutex>

#include "support/made_clouds.h"

namespace tank_datum::bucket_tree_test {

using made_clouds::uniform;
using Places = std::vector<Eigen::Vector3f>;

Places tank() {
  Places places;
  for (const auto& p : made_clouds::tankPoints()) places.push_back(p.cast<float>());
  return places;
}

/// On a coarse grid, where most distances occur many times, and many points lie in one place.
Places grid(std::size_t count, int steps) {
  std::mt19937_64 random(4);
  const auto step = [&] { return static_cast<float>(static_cast<int>(uniform(random) * steps)); };
  Places places;
  for (std::size_t i = 0; i < count; ++i) places.emplace_back(step(), step(), step());
  return places;
}

/// Every point with its distance, in order.
std::vector<FoundPoint> byBruteForce(const Places& places, const Eigen::Vector3f& from) {
  std::vector<std::pair<float, std::int32_t>> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3f d = from - places[i];
    all.emplace_back((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z(), static_cast<std::int32_t>(i));
  }
  std::sort(all.begin(), all.end());
  std::vector<FoundPoint> found;
  for (const auto& [squared, number] : all) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &squared, 4);
    found.push_back(std::uint64_t{bits} << 32 | static_cast<std::uint32_t>(number));
  }
  return found;
}

std::vector<std::int32_t> rowsOf(const Places& places, std::size_t k, int threads = 0) {
  std::vector<std::int32_t> rows(places.size() * k, -1);
  BucketTree(places, threads).nearestOfAll(k, threads, rows.data());
  return rows;
}

void expectRowsOfBruteForce(const Places& places, std::size_t k, std::size_t every) {
  const auto rows = rowsOf(places, k);
  for (std::size_t i = 0; i < places.size(); i += every) {
    const auto expected = byBruteForce(places, places[i]);
    for (std::size_t j = 0; j < k; ++j) ASSERT_EQ(rows[i * k + j], numberOf(expected[j])) << i << " " << j;
  }
}

TEST(BucketTree, FindsWhatABruteForceSearchFinds) {
  Places places = tank();
  places.resize(2000);
  expectRowsOfBruteForce(places, 20, 7);
  expectRowsOfBruteForce(places, 1, 7);
  expectRowsOfBruteForce(places, 130, 97);
}

TEST(BucketTree, OfPointsEquallyFarTheLowerNumberComesFirst) {
  expectRowsOfBruteForce(grid(1500, 6), 20, 11);
  expectRowsOfBruteForce(grid(700, 2), 50, 11);
  expectRowsOfBruteForce(Places(300, Eigen::Vector3f(1, 2, 3)), 20, 11);
}

TEST(BucketTree, FindsAllWhereMostPointsLieInOnePlaceAndOthersFarAway) {
  Places places(6000, Eigen::Vector3f(1, 2, 3));
  for (int i = 0; i < 40; ++i)
    places.emplace_back(static_cast<float>(i * i * i), -7.0F, 0.001F * static_cast<float>(i));
  expectRowsOfBruteForce(places, 25, 301);
}

/// What the bucket before says of the distance is off by a thousand, both ways and again.
TEST(BucketTree, FindsAllWhereTheSpacingChangesAtOnce) {
  Places places;
  for (const Eigen::Vector3f& p : tank()) {
    const bool dense = static_cast<int>(std::floor(p.x())) % 2 == 0;
    places.push_back(dense ? Eigen::Vector3f(std::floor(p.x()) + 0.001F * (p.x() - std::floor(p.x())), 0.001F * p.y(),
                                             0.001F * p.z())
                           : p);
  }
  expectRowsOfBruteForce(places, 20, 37);
}

TEST(BucketTree, AsManyNeighboursAsPointsAreAll) {
  Places places = tank();
  for (const std::size_t count : {1U, 2U, 15U, 16U, 17U, 33U}) {
    const Places some(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count));
    expectRowsOfBruteForce(some, count, 1);
  }
}

TEST(BucketTree, OfNoPointsFindsNone) {
  const BucketTree tree({});
  EXPECT_EQ(tree.size(), 0U);
  EXPECT_TRUE(tree.nearest({0, 0, 0}, 5).empty());
  EXPECT_TRUE(tree.within({0, 0, 0}, 5.0F).empty());
  tree.nearestOfAll(3, 0, nullptr);
}

TEST(BucketTree, HasTheDistancesOfFlannToTheLastBit) {
  const Places places = tank();
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& p : places) cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  pcl::KdTreeFLANN<pcl::PointXYZ> flann;
  flann.setInputCloud(cloud);
  const BucketTree tree(places);
  const auto rows = rowsOf(places, 20);
  pcl::Indices indices;
  std::vector<float> distances;
  for (std::size_t i = 0; i < places.size(); ++i) {
    flann.nearestKSearch((*cloud)[i], 20, indices, distances);
    const auto found = tree.nearest(places[i], 20);
    ASSERT_EQ(found.size(), 20U);
    for (std::size_t j = 0; j < 20; ++j) {
      ASSERT_EQ(squaredDistanceOf(found[j]), distances[j]) << i << " " << j;
      ASSERT_EQ(rows[i * 20 + j], numberOf(found[j])) << i << " " << j;
    }
  }
}

TEST(BucketTree, AroundAnyPlaceFindsTheNearestAndThoseWithin) {
  Places places = tank();
  places.resize(1500);
  const BucketTree tree(places);
  for (const Eigen::Vector3f& place :
       {Eigen::Vector3f(5, 0, 1), Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(90, 9, -9)}) {
    const auto all = byBruteForce(places, place);
    EXPECT_EQ(tree.nearest(place, 40), std::vector<FoundPoint>(all.begin(), all.begin() + 40));
    EXPECT_EQ(tree.nearest(place, 5000), all);
    for (const std::size_t last : {0U, 30U, 1499U}) {
      auto within = tree.within(place, squaredDistanceOf(all[last]));  // the last one lies on the border
      std::sort(within.begin(), within.end());
      EXPECT_EQ(within, std::vector<FoundPoint>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(last) + 1));
    }
  }
}

TEST(BucketTree, DoesNotDependOnTheNumberOfThreads) {
  const Places places = tank();  // more than one task of points
  ASSERT_GT(places.size(), 50'000U);
  const auto one = rowsOf(places, 20, 1);
  EXPECT_EQ(rowsOf(places, 20, 2), one);
  EXPECT_EQ(rowsOf(places, 20, 5), one);
  EXPECT_EQ(rowsOf(places, 20, 0), one);
}

TEST(BucketTree, TellsEveryPointOnceWhenItsRowIsFilled) {
  Places places = tank();
  places.resize(3000);
  std::vector<std::int32_t> rows(places.size() * 4, -1);
  std::vector<int> told(places.size());
  std::size_t unfilled = 0;
  std::mutex mutex;
  BucketTree(places).nearestOfAll(4, 3, rows.data(), [&](const std::uint32_t* points, std::size_t count) {
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::size_t i = 0; i < count; ++i) {
      ++told[points[i]];
      unfilled += rows[points[i] * 4 + 3] < 0;
    }
  });
  EXPECT_EQ(told, std::vector<int>(places.size(), 1));
  EXPECT_EQ(unfilled, 0U);
}

}  // namespace tank_datum::bucket_tree_test
