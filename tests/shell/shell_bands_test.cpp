#include "shell/shell_bands.h"

#include <gtest/gtest.h>

#include <thread>

#include "locate/crop.h"
#include "support/made_shells.h"

namespace tank_datum::shell_bands_test {

using namespace made_shells;

Eigen::Vector3d place(double azimuth, double off, double height) {
  const double r = kRadius + off;
  return {kCentre.x() + r * std::cos(azimuth), kCentre.y() + r * std::sin(azimuth), kFoot + height};
}

std::size_t kept(const Eigen::Vector3d& p, std::size_t height, const ShellOptions& options = everyMetre()) {
  return bandsOf({p}, options).points(height).size();
}

TEST(ShellBands, HeightsAreAFootAboveTheDatumAndEveryStep) {
  ShellOptions options = everyMetre();
  EXPECT_EQ(bandsOf({}).heights()[0], 0.3);
  EXPECT_DOUBLE_EQ(bandsOf({}).heights()[2], 2.3);
  EXPECT_DOUBLE_EQ(bandsOf({}, {}).heights()[2], 1.3);
  options.step = 2.4;
  EXPECT_DOUBLE_EQ(bandsOf({}, options).heights()[2], 5.1);
  options.heights = {0.5, 3.0};
  EXPECT_EQ(bandsOf({}, options).heights(), (std::vector<double>{0.5, 3.0}));
}

/// A scan in other units than it says: as many heights as in metres, however small or large its tank.
TEST(ShellBands, HeightsAreInProportionToATankThatNoneCanBe) {
  for (const double unit : {1e-7, 1e4}) {
    Tank tank = tank10();
    tank.circle.radius *= unit;
    ShellOptions options = everyMetre();
    for (double* length : {&options.step, &options.half_band, &options.reach}) *length *= unit;
    const ShellBands bands(tank, options);
    ASSERT_EQ(bands.heights().size(), bandsOf({}).heights().size());
    EXPECT_NEAR(bands.heights()[2], 2.3 * unit, 1e-9 * unit);
  }
}

TEST(ShellBands, KeepsPointsNearTheShellAtTheHeights) {
  EXPECT_EQ(kept(place(1.0, 0.0, 1.3), 1), 1U);
  EXPECT_EQ(kept(place(1.0, 0.0, 1.3), 0), 0U);
  EXPECT_EQ(kept(place(1.0, 0.0, 1.8), 1), 0U);  // between two heights
  EXPECT_EQ(kept(place(1.0, 0.0, 1.8), 2), 0U);
  EXPECT_EQ(kept(place(1.0, 0.29, 1.3), 1), 1U);
  EXPECT_EQ(kept(place(1.0, -0.29, 1.3), 1), 1U);
  EXPECT_EQ(kept(place(1.0, 0.35, 1.3), 1), 0U);
  EXPECT_EQ(kept(place(1.0, 0.35, 10.3), 10), 1U);  // a leaning shell is off by more higher up
}

TEST(ShellBands, ReachAndBandAreOptions) {
  ShellOptions options = everyMetre();
  options.reach = 0.1;
  EXPECT_EQ(kept(place(1.0, 0.2, 1.3), 1, options), 0U);
  EXPECT_EQ(kept(place(1.0, 0.2, 1.3), 1), 1U);
  options.half_band = 0.3;
  EXPECT_EQ(kept(place(1.0, 0.0, 1.65), 1, options), 1U);
  EXPECT_EQ(kept(place(1.0, 0.0, 1.65), 1), 0U);
}

TEST(ShellBands, ACloseHeightTakesThePointToo) {
  ShellOptions options = everyMetre();
  options.heights = {1.0, 1.1};
  const ShellBands bands = bandsOf({place(2.0, 0.0, 1.05)}, options);
  EXPECT_EQ(bands.points(0).size(), 1U);
  EXPECT_EQ(bands.points(1).size(), 1U);
}

TEST(ShellBands, FewPointsAreKeptAsTheyAreToMicrometres) {
  const Eigen::Vector3d p = place(4.0, 0.0123456, 2.2987654);
  const Points points = bandsOf({p}).points(2);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_LT((points[0] - p).norm(), 3e-6);
}

TEST(ShellBands, ManyPointsAreABoundedEvenSampleOfThem) {
  MadeShell shell;
  shell.from = 0.2, shell.to = 0.4;  // all of it in one band
  const Points all = shell.points();
  ShellOptions options = everyMetre();
  options.cell_points = 50;
  const Points sample = bandsOf(all, options).points(0);
  EXPECT_EQ(sample.size(), 720U * 100U);  // twice the wanted, since the band is kept twice as wide as it is used
  double late = 0, above = 0;
  for (const auto& p : sample) above += p.z() > kFoot + 0.3;
  EXPECT_NEAR(above / static_cast<double>(sample.size()), 0.5, 0.01);
  for (std::size_t i = all.size() / 2; i < all.size(); i += 100) {  // the end of a scan counts as its beginning does
    late += std::any_of(sample.begin(), sample.end(), [&](const auto& p) { return (p - all[i]).norm() < 3e-6; });
  }
  EXPECT_NEAR(late * 100 / (0.5 * static_cast<double>(all.size())), 72'000.0 / 400'000.0, 0.03);
  EXPECT_EQ(bandsOf(all, options).points(0), sample);  // and the same each time
}

TEST(ShellBands, BlocksChangeNothing) {
  MadeShell shell;
  shell.count = 50'000;
  const Points all = shell.points();
  ShellBands parts(tank10(), everyMetre());
  for (std::size_t i = 0; i < all.size(); i += 7000) {
    parts.gather(0, Points(all.begin() + static_cast<std::ptrdiff_t>(i),
                           all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), i + 7000))));
  }
  const ShellBands whole = bandsOf(all);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(parts.points(k), whole.points(k));
}

TEST(ShellBands, KeepsTheSamePointsInAnyOrder) {
  MadeShell shell;
  shell.from = 0.2, shell.to = 0.4;
  Points all = shell.points();
  ShellOptions options = everyMetre();
  options.cell_points = 50;
  const Points sample = bandsOf(all, options).points(0);
  std::reverse(all.begin(), all.end());
  EXPECT_EQ(bandsOf(all, options).points(0), sample);
}

// Millions of points have pairs of one hash; here all of a cell have, since they differ by less than it tells apart.
TEST(ShellBands, KeepsTheSameOfPointsOfOneHashInAnyOrder) {
  ShellOptions options = everyMetre();
  options.cell_points = 50;
  Points all;
  for (int i = 0; i < 400; ++i) all.push_back(place(1.0, 0.0, 0.3) + Eigen::Vector3d(0.0, 0.0, 1e-8 * (i * 37 % 400)));
  const Points sample = bandsOf(all, options).points(0);
  EXPECT_EQ(sample.size(), 100U);
  std::reverse(all.begin(), all.end());
  EXPECT_EQ(bandsOf(all, options).points(0), sample);
}

TEST(ShellBands, GathersInSeveralThreadsWhatOneGathers) {
  MadeShell shell;
  shell.from = 0.2, shell.to = 3.6;
  const Points all = shell.points();
  ShellOptions options = everyMetre();
  options.cell_points = 50;
  ShellBands bands(tank10(), options);
  const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  const auto gather = [&bands](auto from, auto to) {
    while (from != to) {
      const auto end = from + std::min<std::ptrdiff_t>(1000, to - from);
      bands.gather(0, Points(from, end));
      from = end;
    }
  };
  std::thread other([&] { gather(all.begin(), half); });
  gather(half, all.end());
  other.join();
  const ShellBands alone = bandsOf(all, options);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(bands.points(k), alone.points(k));
}

TEST(ShellBands, OfAHugeScanEveryNthPointIsLookedAt) {
  const Points block(100, place(1.0, 0.0, 1.3));
  const auto gathered = [&](std::uint64_t points, std::uint64_t n) {
    ShellBands bands(tank10(), everyMetre(), points);
    bands.gather(n, block);
    return bands.points(1).size();
  };
  EXPECT_EQ(gathered(kPointsLookedAt - 1, 0), 100U);
  EXPECT_EQ(gathered(5 * kPointsLookedAt, 0), 20U);
  EXPECT_EQ(gathered(9 * kPointsLookedAt, 2), 11U);  // 2, 11, ... 92: blocks do not all begin with their first
}

}  // namespace tank_datum::shell_bands_test
