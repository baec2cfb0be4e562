#include <gtest/gtest.h>

#include <cmath>

#include "bench/memory_speed.h"

namespace tank_datum::bench::bench_stages_test {

/// 1000 rows of 16 bytes; every fifth row located, all cropped.
RunSizes sizes() {
  RunSizes sizes;
  sizes.file_bytes = 16'000;
  sizes.located = 200;
  sizes.cropped = 1000;
  sizes.ring = 100;
  sizes.search = 50;
  sizes.k = 20;
  sizes.candidates = 10;
  sizes.edge = 5;
  sizes.stations = 4;
  sizes.shell = 300;
  sizes.report_bytes = 8000;
  return sizes;
}

TEST(WorkOf, IsInputReadOnceAndResultWrittenOnce) {
  const auto work = workOf(sizes());
  const auto expect = [&](const char* stage, std::uint64_t points, double bytes) {
    EXPECT_EQ(work.at(stage).points, points) << stage;
    EXPECT_DOUBLE_EQ(work.at(stage).bytes_per_point, bytes) << stage;
  };
  expect("locate", 200, 64.0 + 24.0);  // a row's line of the cache, a point of three doubles
  expect("crop", 1000, 16.0 + (24.0 * 150 + 12.0 * 300) / 1000.0);
  expect("setups", 100, 24.0);
  expect("normals", 50, 24.0 + 20 * 4.0 + 12.0);
  expect("region_growing", 50, 20 * 4.0 + 12.0);
  expect("centre_filter", 10, 28.0);
  expect("spline", 5, 24.0);
  expect("refine", 100, 24.0);
  expect("shell", 300, 12.0);
  expect("report", 4, 2000.0);
  EXPECT_EQ(work.count("open") + work.count("hash"), 0U);
}

TEST(SpeedOf, IsTheShareOfWhatMemoryGives) {
  const StageSpeed speed = speedOf(0.002, {1'000'000, 50.0}, 100e9);
  EXPECT_DOUBLE_EQ(speed.ns_per_point, 2.0);
  EXPECT_DOUBLE_EQ(speed.bandwidth_share, 0.25);  // 50 MB in 2 ms, of 100 GB/s
}

TEST(SpeedOf, IsNotKnownOfNoPoints) {
  const StageSpeed speed = speedOf(0.002, {}, 100e9);
  EXPECT_EQ(speed.seconds, 0.002);
  EXPECT_TRUE(std::isnan(speed.ns_per_point));
  EXPECT_TRUE(std::isnan(speed.bandwidth_share));
}

TEST(LimitsOf, MeasuresThreadsByWhatAsManyMove) {
  const std::vector<StageCost> one = {{"open", 0.3, 0.3, 0}, {"refine", 1.0, 1.0, 0}},
                               two = {{"open", 0.2, 0.2, 0}, {"refine", 0.4, 0.8, 0}};
  const auto limits = limitsOf(one, two, {{"refine", {1'000'000'000, 24.0}}}, {96e9, 120e9});
  ASSERT_EQ(limits.size(), 2U);
  EXPECT_EQ(limits[0].name, "open");
  EXPECT_EQ(limits[0].work.points, 0U);
  EXPECT_DOUBLE_EQ(limits[0].ratio, 1.5);
  EXPECT_DOUBLE_EQ(limits[1].one.bandwidth_share, 0.25);
  EXPECT_DOUBLE_EQ(limits[1].two.bandwidth_share, 0.5);
  EXPECT_DOUBLE_EQ(limits[1].two.ns_per_point, 0.4);
  EXPECT_DOUBLE_EQ(limits[1].ratio, 2.5);
}

TEST(MemorySpeed, IsTheQuickerOfReadAndCopy) {
  const MemorySpeed speed{{10e9, 30e9}, {20e9, 25e9}};
  EXPECT_EQ(speed.best().one, 20e9);
  EXPECT_EQ(speed.best().two, 30e9);
}

TEST(KeepFastest, TakesEachSpeedOfTheMemoryByItself) {
  MemorySpeed best;
  keepFastest(best, {{10e9, 30e9}, {20e9, 25e9}});
  keepFastest(best, {{12e9, 20e9}, {15e9, 26e9}});
  EXPECT_EQ(best.read.one, 12e9);
  EXPECT_EQ(best.read.two, 30e9);
  EXPECT_EQ(best.copy.one, 20e9);
  EXPECT_EQ(best.copy.two, 26e9);
}

TEST(KeepFastest, TakesEachStageByItself) {
  std::vector<StageCost> best;
  keepFastest(best, {{"locate", 2.0, 2.0, 0}, {"crop", 1.0, 1.0, 0}});
  keepFastest(best, {{"locate", 1.0, 1.0, 0}, {"crop", 3.0, 3.0, 0}});
  EXPECT_EQ(best[0].seconds, 1.0);
  EXPECT_EQ(best[1].seconds, 1.0);
}

}  // namespace tank_datum::bench::bench_stages_test
