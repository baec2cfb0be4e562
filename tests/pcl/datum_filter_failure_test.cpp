#include <gtest/gtest.h>

#include <string>

#include "support/pcl_clouds.h"
#include "tank_datum/core/error.h"
#include "tank_datum/pcl/datum_filter.h"

namespace tank_datum::datum_filter_failure_test {

using made_clouds::floorPoints;
using pcl_clouds::cloudOf;
using pcl_clouds::tankCloud;
using pcl_clouds::toTheEdge;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Filter = DatumFilter<pcl::PointXYZ>;

/// A filter that has just found the made tank's datum, and its output.
struct Ran {
  Filter filter{true};
  Cloud output;
  pcl::Indices indices;

  Ran() {
    filter.setOptions(toTheEdge());
    filter.setInputCloud(tankCloud<pcl::PointXYZ>());
    filter.filter(output);
    filter.filter(indices);
  }
};

void expectNothing(const Filter& filter, Status status) {
  EXPECT_EQ(filter.getDatum().status, status) << filter.getDatum().message;
  EXPECT_FALSE(filter.getDatum().usable());
  EXPECT_TRUE(filter.getDatum().stations.empty());
}

TEST(DatumFilterFailure, BeforeARunItSaysSo) { expectNothing(Filter(), Status::NotRun); }

TEST(DatumFilterFailure, WithoutInputItDoesNotRunAndTheLastDatumIsGone) {
  Ran ran;
  ASSERT_TRUE(ran.filter.getDatum().usable());
  ASSERT_FALSE(ran.filter.getRemovedIndices()->empty());
  ran.filter.setInputCloud(nullptr);
  pcl::Indices untouched = {1, 2};
  ran.filter.filter(untouched);
  EXPECT_EQ(untouched, (pcl::Indices{1, 2}));  // as with every filter of PCL
  expectNothing(ran.filter, Status::NotRun);
  EXPECT_TRUE(ran.filter.getRemovedIndices()->empty());
}

TEST(DatumFilterFailure, OfAnEmptyCloudHasTooFewPoints) {
  Ran ran;
  ran.filter.setInputCloud(std::make_shared<Cloud>());
  ran.filter.filter(ran.output);
  ran.filter.filter(ran.indices);
  EXPECT_TRUE(ran.output.empty());
  EXPECT_TRUE(ran.indices.empty());
  EXPECT_TRUE(ran.filter.getRemovedIndices()->empty());
  expectNothing(ran.filter, Status::TooFewPoints);
}

TEST(DatumFilterFailure, OfACloudWithoutATankHasNoEdgePoints) {
  Ran ran;
  ran.filter.setOptions({});
  const auto floor = cloudOf<pcl::PointXYZ>(floorPoints(5'000, 8.0));
  ran.filter.setInputCloud(floor);
  ran.filter.filter(ran.output);
  EXPECT_TRUE(ran.output.empty());
  EXPECT_EQ(ran.filter.getRemovedIndices()->size(), floor->size());
  expectNothing(ran.filter, Status::NoTank);
  ran.filter.setNegative(true);
  ran.filter.filter(ran.output);
  EXPECT_EQ(ran.output.size(), floor->size());
}

TEST(DatumFilterFailure, TwoCloudsInARowGiveWhatEachGivesAlone) {
  Ran ran;
  const auto all = tankCloud<pcl::PointXYZ>({3, -2, 1});
  auto second = std::make_shared<Cloud>(*all);
  second->resize(all->size() * 5 / 6);  // fewer points than the first
  DatumOptions options = toTheEdge({3, -2});
  ran.filter.setOptions(options);
  ran.filter.setInputCloud(second);
  ran.filter.filter(ran.indices);

  Filter alone(true);
  alone.setOptions(options);
  alone.setInputCloud(second);
  pcl::Indices expected;
  alone.filter(expected);
  EXPECT_GT(expected.size(), 500U);
  EXPECT_EQ(ran.indices, expected);
  EXPECT_EQ(*ran.filter.getRemovedIndices(), *alone.getRemovedIndices());
  EXPECT_EQ(ran.filter.getDatum().edge_points, alone.getDatum().edge_points);
  EXPECT_EQ(ran.filter.getDatum().origin, alone.getDatum().origin);
}

TEST(DatumFilterFailure, TheLastRunsRemovedIndicesStayWithWhoeverTookThem) {
  Ran ran;
  const auto taken = ran.filter.getRemovedIndices();
  const std::size_t size = taken->size();
  ran.filter.setInputCloud(std::make_shared<Cloud>());
  ran.filter.filter(ran.indices);
  EXPECT_EQ(taken->size(), size);
}

/// Runs the filter both ways; each must throw with this text and leave nothing behind.
void expectRefused(Ran& ran, const std::string& text) {
  const auto refused = [&](auto& output) {
    try {
      ran.filter.filter(output);
      ADD_FAILURE() << "accepted, expected: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Option);
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
    EXPECT_TRUE(output.empty());
    EXPECT_TRUE(ran.filter.getRemovedIndices()->empty());
    expectNothing(ran.filter, Status::NotRun);
  };
  refused(ran.output);
  refused(ran.indices);
}

TEST(DatumFilterFailure, ARefusedOptionIsNamedAndNothingStale) {
  Ran ran;
  DatumOptions options = toTheEdge();
  options.normals.k = 2;
  ran.filter.setOptions(options);
  expectRefused(ran, "options: k, 2");
}

TEST(DatumFilterFailure, AnIndexOutsideOfTheCloudIsNamedAndNothingStale) {
  for (const pcl::index_t index : {-1, 1'000'000}) {
    Ran ran;
    ran.filter.setIndices(std::make_shared<pcl::Indices>(pcl::Indices{0, index}));
    expectRefused(ran, "filter: index, " + std::to_string(index));
  }
}

}  // namespace tank_datum::datum_filter_failure_test
