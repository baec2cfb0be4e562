#include "setups/parts_by_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"

namespace tank_datum::parts_by_order_test {

constexpr double kRadius = 10.0;

/// A cloud of scans without labels, column after column.
class Cloud {
 public:
  Cloud() { ring_.reach = 0.5; }

  /// A setup that looks at the shell from 10 m off it, from one azimuth to another [deg]: points are as dense there as
  /// its rays are.
  Cloud& sweep(double middle, double from, double to) {
    const double step = from < to ? 0.05 : -0.05;
    for (double at = from; step * (to - at) > 0.0; at += step) {
      const double turn = toRadians(at - middle), away = 2.0 * kRadius;
      const double range = std::sqrt(kRadius * kRadius + away * away - 2.0 * kRadius * away * std::cos(turn));
      const double cosine = (away * std::cos(turn) - kRadius) / range;
      if (cosine > 0.0) column(at, static_cast<int>(1.0 + 60.0 * cosine * kRadius / range));
    }
    return *this;
  }

  /// Points on the shell and the foundation at an azimuth [deg].
  void column(double azimuth, int count) {
    for (int i = 0; i < count; ++i) {
      const double d = i % 3 == 0 ? 0.3 * any_(random_) : 0.0, z = d > 0.0 ? 0.0 : 0.5 * any_(random_);
      const double turn = toRadians(azimuth);
      ring_.points.push_back({(kRadius + d) * std::cos(turn), (kRadius + d) * std::sin(turn), z});
    }
  }

  std::size_t size() const { return ring_.points.size(); }
  Ring& ring() { return ring_; }
  std::vector<std::size_t> parts(Side side = Side::Outside) const {
    Tank tank;
    tank.side = side;
    tank.circle = {{0.0, 0.0}, kRadius};
    tank.foot.coefficients = Eigen::Vector3d::Zero();
    return partsByOrder(ring_, tank);
  }

 private:
  Ring ring_;
  std::mt19937_64 random_{5};
  std::uniform_real_distribution<double> any_;
};

/// Six setups, one after the other, each of which sees 120 degrees.
Cloud sixSetups(std::vector<std::size_t>* begins = nullptr) {
  Cloud cloud;
  for (const double middle : {0.0, 60.0, 120.0, 180.0, 240.0, 300.0}) {
    if (begins) begins->push_back(cloud.size());
    cloud.sweep(middle, middle - 60.0, middle + 60.0);
  }
  return cloud;
}

/// Whether parts begin where they should, but for so many points.
void expectBegins(const std::vector<std::size_t>& found, const std::vector<std::size_t>& expected, double within) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(found[i]), static_cast<double>(expected[i]), within) << i;
  }
}

TEST(PartsByOrder, EachSetupOfAMergedCloudIsOne) {
  std::vector<std::size_t> begins;
  const Cloud cloud = sixSetups(&begins);
  expectBegins(cloud.parts(), begins, 60.0);
}

TEST(PartsByOrder, OfOneSetupThereIsOne) {
  EXPECT_TRUE(Cloud().sweep(0.0, -60.0, 60.0).parts().empty());
  EXPECT_TRUE(Cloud().sweep(0.0, 10.0, 60.0).sweep(0.0, -60.0, 10.0).parts().empty());
}

TEST(PartsByOrder, WhichNoneSeesWhatAnotherSeesIsNotTold) {
  EXPECT_TRUE(Cloud().sweep(0.0, -55.0, 55.0).sweep(120.0, 65.0, 175.0).parts().empty());
  EXPECT_EQ(Cloud().sweep(0.0, -55.0, 55.0).sweep(90.0, 35.0, 145.0).parts().size(), 2U);
}

TEST(PartsByOrder, ASweepThatBeginsBeforeTheShellIsOneSetup) {
  Cloud cloud;
  cloud.sweep(0.0, 20.0, 60.0).sweep(0.0, -60.0, 20.0);
  const std::size_t second = cloud.size();
  cloud.sweep(60.0, 0.0, 120.0);
  expectBegins(cloud.parts(), {0, second}, 60.0);
}

TEST(PartsByOrder, ASweepThatSomethingCutsIsOneSetup) {
  for (const double hidden : {10.0, 25.0}) {
    Cloud cloud;
    cloud.sweep(0.0, -60.0, -10.0).sweep(0.0, -10.0 + hidden, 60.0);
    const std::size_t second = cloud.size();
    cloud.sweep(60.0, 0.0, 120.0);
    expectBegins(cloud.parts(), {0, second}, 60.0);
  }
}

/// Where one setup begins as the one before it ends, nothing parts them: more is seen than one setup sees.
TEST(PartsByOrder, SetupsThatMeetEndToEndAreNotTold) {
  const auto parts = [](double gap, Side side) {
    Cloud cloud;
    return cloud.sweep(0.0, -60.0, 60.0).sweep(120.0, 60.0 + gap, 180.0).sweep(60.0, 0.0, 120.0).parts(side).size();
  };
  EXPECT_EQ(parts(0.0, Side::Outside), 0U);
  EXPECT_EQ(parts(0.0, Side::Inside), 2U);
  EXPECT_EQ(parts(10.0, Side::Outside), 3U);
}

TEST(PartsByOrder, ShuffledPointsAndRowsSayNothing) {
  Cloud cloud = sixSetups();
  Points& points = cloud.ring().points;
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z() < b.z(); });
  EXPECT_TRUE(cloud.parts().empty());
  std::shuffle(points.begin(), points.end(), std::mt19937_64(1));
  EXPECT_TRUE(cloud.parts().empty());
}

/// Setups whose rows follow each other see all their arcs all the time: where one ends and the next begins is not told.
TEST(PartsByOrder, SetupsOfWhichEachIsInRowsSayNothing) {
  std::vector<std::size_t> begins;
  Cloud cloud = sixSetups(&begins);
  Points& points = cloud.ring().points;
  for (std::size_t s = 0; s < begins.size(); ++s) {
    const auto end = s + 1 < begins.size() ? points.begin() + static_cast<std::ptrdiff_t>(begins[s + 1]) : points.end();
    std::sort(points.begin() + static_cast<std::ptrdiff_t>(begins[s]), end,
              [](const auto& a, const auto& b) { return a.z() < b.z(); });
  }
  EXPECT_TRUE(cloud.parts().empty());
}

/// Slices of a cloud that was sorted by height see each arc again and again, but never from its foot to its top.
TEST(PartsByOrder, SlicesOfHeightAreNoSetups) {
  Cloud cloud = sixSetups();
  Points& points = cloud.ring().points;
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return std::floor(a.z() / 0.17) < std::floor(b.z() / 0.17); });
  EXPECT_TRUE(cloud.parts().empty());
}

TEST(PartsByOrder, StraysDoNotMatter) {
  std::vector<std::size_t> begins;
  Cloud cloud = sixSetups(&begins);
  std::mt19937_64 random(7);
  std::uniform_int_distribution<std::size_t> any(0, cloud.size() - 1);
  Points& points = cloud.ring().points;
  for (std::size_t i = 0; i < points.size(); i += 50) points[i] = points[any(random)];
  expectBegins(cloud.parts(), begins, 0.03 * static_cast<double>(begins[1]));
}

TEST(PartsByOrder, OfAVastCloudEveryNthPointIsLookedAt) {
  std::vector<std::size_t> begins;
  Cloud cloud = sixSetups(&begins);
  Points all;
  const std::size_t times = 1'700'000 / cloud.size() + 1;
  for (const Eigen::Vector3d& p : cloud.ring().points) all.insert(all.end(), times, p);
  cloud.ring().points = all;
  for (std::size_t& begin : begins) begin *= times;
  expectBegins(cloud.parts(), begins, 60.0 * static_cast<double>(times));
}

}  // namespace tank_datum::parts_by_order_test
