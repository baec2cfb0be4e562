#include "foot/foot_bridges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"

namespace tank_datum::foot_bridges_test {

using namespace made_feet;

/// Stations of a level ring, of which some are not measured; where those are, the shell is seen down to so far below
/// the others with so many points a station.
/// @param no_shell  so many stations from 110 on have no shell
std::vector<StationDatum> bridgedOver(const std::vector<int>& gap, double down_to, int count,
                                      double longest_bridge = StationOptions().longest_bridge, int no_shell = 0) {
  MadeFoot made;
  for (const int s : gap) {
    for (int i = 0; i < count; ++i) made.add(s * made.step(), 0.0, -down_to * (i + 0.5) / count);
    for (int i = 0; i < 4; ++i) made.add(s * made.step(), 0.0, 0.006 + 0.004 * i);
  }
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations(360);
  for (std::size_t i = 0; i < stations.size(); ++i) {
    StationDatum& s = stations[i];
    s.direction = foot.directions[i];
    s.flag = StationFlag::Measured;
    s.z = 0.0, s.sigma_z = 0.0002, s.radius = kRadius, s.sigma_radius = 0.0001;
  }
  for (const int s : gap) {
    stations[static_cast<std::size_t>(s)].flag = StationFlag::Missing;
    stations[static_cast<std::size_t>(s)].reason =
        s >= 110 && s < 110 + no_shell ? Unmeasured::NoShell : Unmeasured::Hidden;
  }
  StationOptions options;
  options.longest_bridge = longest_bridge;
  return withGapsBridged(stations, {}, foot, {{{0.0, 0.0}, kRadius}, 1e-4, options});
}

TEST(WithGapsBridged, AGapWhoseShellEndsAtTheBridgeIsBridged) {
  for (const StationDatum& s : bridgedOver({100, 101, 102}, 0.0, 8)) {
    EXPECT_NE(s.flag, StationFlag::Missing);
    EXPECT_NEAR(s.z, 0.0, 1e-9);
  }
}

TEST(WithGapsBridged, AGapBelowWhoseBridgeTheShellGoesOnHasNoDatum) {
  const auto stations = bridgedOver({100, 101, 102, 200}, 0.02, 8);
  for (const std::size_t i : {100U, 101U, 102U, 200U}) {
    EXPECT_EQ(stations[i].flag, StationFlag::Missing) << i;
    EXPECT_EQ(stations[i].reason, Unmeasured::ShellBelow) << i;
    EXPECT_TRUE(std::isnan(stations[i].z)) << i;
  }
  EXPECT_EQ(stations[99].flag, StationFlag::Measured);
}

/// What bridges two stations of a ring at 0 along a process at 0, where the stations beside them lie so far lower.
StationDatum bridgeBetween(double low) {
  MadeFoot made;
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations = bridgedOver({}, 0.0, 1);
  for (const std::size_t i : {99U, 102U}) stations[i].z = -low;
  for (const std::size_t i : {100U, 101U}) stations[i] = {};
  RingProcess process;
  process.amplitude = 0.001, process.length = 0.1;
  process.value.assign(360, 0.0), process.sigma.assign(360, 0.0001);
  return withGapsBridged(stations, process, foot, {{{0.0, 0.0}, kRadius}, 1e-9, {}})[100];
}

TEST(WithGapsBridged, FollowTheProcessUnlessTheStationsBesideDoNot) {
  EXPECT_EQ(bridgeBetween(0.0006).z, 0.0);
  EXPECT_NEAR(bridgeBetween(0.0008).z, -0.0008, 1e-9);
  EXPECT_NEAR(bridgeBetween(0.020).sigma_z, 0.3 * 0.020, 0.0001);
  EXPECT_LT(bridgeBetween(0.0006).sigma_z, 0.0005);
}

TEST(WithGapsBridged, NoneIsSurerFurtherInThanOnBothSides) {
  MadeFoot made;
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations = bridgedOver({}, 0.0, 1);
  for (std::size_t i = 100; i < 105; ++i) stations[i] = {};
  RingProcess process;
  process.amplitude = 0.001, process.length = 0.1;
  process.value.assign(360, 0.0), process.sigma.assign(360, 0.0001);
  process.sigma[100] = 0.003, process.sigma[101] = 0.020, process.sigma[103] = 0.010;
  const auto bridged = withGapsBridged(stations, process, foot, {{{0.0, 0.0}, kRadius}, 1e-9, {}});
  EXPECT_NEAR(bridged[100].sigma_z, 0.003, 1e-5);
  EXPECT_NEAR(bridged[101].sigma_z, 0.020, 1e-5);
  EXPECT_NEAR(bridged[102].sigma_z, 0.010, 1e-5);
  EXPECT_NEAR(bridged[103].sigma_z, 0.010, 1e-5);
  EXPECT_LT(bridged[104].sigma_z, 0.0005);
}

TEST(WithGapsBridged, ThreeNeighboursTellTogether) {
  const auto below = [](const std::vector<int>& gap, int count) {
    return bridgedOver(gap, 0.02, count)[100].reason == Unmeasured::ShellBelow;
  };
  EXPECT_FALSE(below({100}, 3)) << "three points of the shell may be stray";
  EXPECT_TRUE(below({100, 101, 102}, 3));
}

TEST(WithGapsBridged, WhereTheShellGoesOnBelowAThirdOfTheStationsNoneStands) {
  const auto measured = [](int wide) {
    std::vector<int> gap;
    for (int s = 0; s < wide; ++s) gap.push_back(100 + s);
    const auto stations = bridgedOver(gap, 0.02, 8, kTwoPi / 2.0);
    return std::count_if(stations.begin(), stations.end(),
                         [](const StationDatum& s) { return s.flag == StationFlag::Measured; });
  };
  EXPECT_EQ(measured(60), 300);
  EXPECT_EQ(measured(115), 245);
  EXPECT_EQ(measured(125), 0);
}

TEST(WithGapsBridged, WhereNoShellIsSeenItDoesNotGoOnBelow) {
  std::vector<int> gap;
  for (int s = 100; s < 240; ++s) gap.push_back(s);
  const auto stations = bridgedOver(gap, 0.02, 8, kTwoPi / 2.0, 130);
  EXPECT_EQ(stations[105].reason, Unmeasured::ShellBelow);
  EXPECT_EQ(stations[50].flag, StationFlag::Measured);
}

TEST(WithGapsBridged, AProcessThatGoesAstrayInALongGapIsNotWhereTheShellIsExpectedToEnd) {
  const auto bridgedAt = [](double line, double astray) {
    MadeFoot made;
    for (int s = 100; s < 220; ++s) {
      for (int i = 0; i < 12; ++i) made.add(s * made.step(), 0.0, 0.004 + 0.004 * i);
    }
    const Foot& foot = made.foot();
    std::vector<StationDatum> stations = bridgedOver({}, 0.0, 1);
    for (StationDatum& s : stations) s.z = line;
    for (std::size_t i = 100; i < 220; ++i) stations[i] = {}, stations[i].reason = Unmeasured::OtherSurface;
    RingProcess process;
    process.amplitude = 0.001, process.length = 0.1;
    process.value.assign(360, line + astray), process.sigma.assign(360, 0.001);
    return withGapsBridged(stations, process, foot, {{{0.0, 0.0}, kRadius}, 1e-4, {}});
  };
  EXPECT_EQ(bridgedAt(0.0, 0.04)[50].flag, StationFlag::Measured);
  EXPECT_EQ(bridgedAt(0.0, 0.04)[160].reason, Unmeasured::OtherSurface);
  EXPECT_EQ(bridgedAt(0.04, 0.0)[160].reason, Unmeasured::ShellBelow) << "below the line too";
}

/// Whether a station beside a gap below which the shell goes on stands, with so many points of it below and above.
bool standsBeside(int below, int above) {
  MadeFoot made;
  for (int i = 0; i < 8; ++i) made.add(100 * made.step(), 0.0, -0.010 - 0.001 * i);
  for (int i = 0; i < below; ++i) made.add(101 * made.step(), 0.0, -0.010 - 0.001 * i);
  for (int i = 0; i < above; ++i) made.add(101 * made.step(), 0.0, 0.010 + 0.001 * i);
  const Foot& foot = made.foot();
  std::vector<StationDatum> stations = bridgedOver({}, 0.0, 1);
  stations[100] = {};
  stations = withGapsBridged(stations, {}, foot, {{{0.0, 0.0}, kRadius}, 1e-4, {}});
  EXPECT_EQ(stations[100].reason, Unmeasured::ShellBelow);
  EXPECT_EQ(stations[102].flag, StationFlag::Measured);
  return stations[101].flag == StationFlag::Measured;
}

TEST(WithGapsBridged, BesideSuchAGapFewPointsBelowWillDo) {
  EXPECT_FALSE(standsBeside(1, 4));
  EXPECT_TRUE(standsBeside(1, 5));
  EXPECT_TRUE(standsBeside(0, 0));
}

}  // namespace tank_datum::foot_bridges_test
