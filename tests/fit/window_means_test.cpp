#include "fit/window_means.h"

#include <gtest/gtest.h>

#include <array>

#include "core/units.h"

namespace tank_datum::window_means_test {

std::vector<double> quarters() { return {0.0, 90 * kDegree, 180 * kDegree, 270 * kDegree}; }

TEST(WindowsOver, ReachHalfTheirWidthToEitherSideAndOverZero) {
  const std::vector<Window> alone = windowsOver(quarters(), 0.0), three = windowsOver(quarters(), 180 * kDegree);
  EXPECT_EQ(alone[2].first, 2U);
  EXPECT_EQ(alone[2].end, 3U);
  EXPECT_EQ(three[0].first, 3U);
  EXPECT_EQ(three[0].end, 6U);
  EXPECT_EQ(windowsOver(quarters(), 360 * kDegree)[1].end - windowsOver(quarters(), 360 * kDegree)[1].first, 4U);
}

TEST(WindowMeans, AreWeightedAndPassOverWhatHasNoWeight) {
  const std::array<float, 4> values = {1.0F, 2.0F, 3.0F, 100.0F};
  std::array<float, 4> means = {};
  WindowMeans(windowsOver(quarters(), 180 * kDegree), {1.0, 3.0, 1.0, 0.0}).of(values.data(), means.data());
  EXPECT_FLOAT_EQ(means[0], (1.0F + 6.0F) / 4.0F);
  EXPECT_FLOAT_EQ(means[1], (1.0F + 6.0F + 3.0F) / 5.0F);
  EXPECT_FLOAT_EQ(means[3], 2.0F);
  WindowMeans(windowsOver(quarters(), 0.0), {1.0, 3.0, 1.0, 0.0}).of(values.data(), means.data());
  EXPECT_FLOAT_EQ(means[1], 2.0F);
  EXPECT_FLOAT_EQ(means[3], 0.0F);
}

TEST(WindowMeans, OfNoValuesAreNone) {
  WindowMeans none({}, {});
  none.of(nullptr, nullptr);
  EXPECT_TRUE(windowsOver({}, 1.0).empty());
}

}  // namespace tank_datum::window_means_test
