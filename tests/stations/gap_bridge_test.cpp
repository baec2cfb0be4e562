#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/units.h"
#include "stations/stations.h"

namespace tank_datum::gap_bridge_test {

constexpr double kRadius = 10.0;
constexpr double kStep = kDegree * kRadius;  // arc between stations [m]
const Eigen::Vector2d kCenter(3.0, -4.0);

using Curve = std::function<double(double)>;  // of the arc from the middle of the gap [m]

double level(double) { return 2.0; }
double circular(double) { return kRadius; }

std::vector<StationDatum> places() {
  const std::vector<Station> stations = emptyStations({});
  return {stations.begin(), stations.end()};
}

/// 360 stations measured on a curve, but for a gap of `length` stations from the first, bridged.
struct Bridged {
  std::vector<StationDatum> stations = places();
  std::size_t first, length;

  Bridged(std::size_t from, std::size_t count, const Curve& height, double sigma_bend = 0.0, double sigma = 1e-4,
          const Curve& radius = circular)
      : first(from), length(count) {
    std::vector<bool> supported;
    for (std::size_t i = 0; i < 360; ++i) supported.push_back((i + 360 - first) % 360 >= length);
    for (std::size_t i = 0; i < 360; ++i) {
      if (!supported[i]) continue;
      StationDatum& s = stations[i];
      s.z = height(arc(i));
      s.radius = radius(arc(i));
      s.sigma_z = s.sigma_radius = sigma;
    }
    const std::vector<StationFlag> flags = flagsOf(supported, {});
    for (std::size_t i = 0; i < 360; ++i) stations[i].flag = flags[i];
    stations = bridgeGaps(stations, kCenter, sigma_bend);
  }
  double arc(std::size_t station) const {
    const double middle = static_cast<double>(first) + 0.5 * static_cast<double>(length - 1);
    return kStep * std::remainder(static_cast<double>(station) - middle, 360.0);
  }
  const StationDatum& inGap(std::size_t i) const { return stations[(first + i) % 360]; }
};

TEST(BridgeGaps, OfALevelDatumIsLevel) {
  const Bridged bridged(100, 1, level);
  const StationDatum& s = bridged.inGap(0);
  EXPECT_EQ(s.flag, StationFlag::Interpolated);
  EXPECT_NEAR(s.z, 2.0, 1e-12);
  EXPECT_NEAR(s.radius, kRadius, 1e-12);
  EXPECT_NEAR(s.x, kCenter.x() + kRadius * std::cos(s.direction), 1e-12);
  EXPECT_NEAR(s.y, kCenter.y() + kRadius * std::sin(s.direction), 1e-12);
}

TEST(BridgeGaps, ReproduceAParabolaExactly) {
  const auto parabola = [](double t) { return 2.0 + 0.003 * t - 0.002 * t * t; };
  for (const std::size_t length : {1U, 5U, 10U}) {
    const Bridged bridged(100, length, parabola);
    for (std::size_t i = 0; i < length; ++i) {
      EXPECT_NEAR(bridged.inGap(i).z, parabola(bridged.arc(100 + i)), 1e-9) << length << " " << i;
    }
  }
}

TEST(BridgeGaps, TheRadiusGoesOverTheGapTooAndThePlanFollowsIt) {
  const auto oval = [](double t) { return kRadius + 0.01 * t; };
  const Bridged bridged(100, 5, level, 0.0, 1e-4, oval);
  for (std::size_t i = 0; i < 5; ++i) {
    const StationDatum& s = bridged.inGap(i);
    EXPECT_NEAR(s.radius, oval(bridged.arc(100 + i)), 2e-4);  // the arc itself is counted at each station's own radius
    EXPECT_NEAR((Eigen::Vector2d(s.x, s.y) - kCenter).norm(), s.radius, 1e-12);
  }
  EXPECT_GT(bridged.inGap(4).radius - bridged.inGap(0).radius, 0.006);
}

TEST(BridgeGaps, GoRoundTheSeam) {
  const auto parabola = [](double t) { return 2.0 + 0.003 * t - 0.002 * t * t; };
  const Bridged bridged(356, 8, parabola);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(bridged.inGap(i).flag, StationFlag::Interpolated);
    EXPECT_NEAR(bridged.inGap(i).z, parabola(bridged.arc(356 + i)), 1e-9);
  }
}

TEST(BridgeGaps, SigmaGrowsTowardsTheMiddleByWhatABendMayDo) {
  const double sigma_bend = 0.003;
  const Bridged bridged(100, 9, level, sigma_bend, 1e-6);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(bridged.inGap(i).sigma_z, bridged.inGap(i + 1).sigma_z);
    EXPECT_NEAR(bridged.inGap(i).sigma_z, bridged.inGap(8 - i).sigma_z, 1e-9);
  }
  // a curve of bend b between two supports a and c away leaves their chord by b a c / 2
  EXPECT_NEAR(bridged.inGap(4).sigma_z, 0.5 * sigma_bend * 25.0 * kStep * kStep, 1e-5);
}

TEST(BridgeGaps, WithoutABendSigmaIsThatOfTheStationsBeside) {  // which share more than noise
  EXPECT_NEAR(Bridged(100, 5, level, 0.0, 1e-4).inGap(2).sigma_z, 1e-4, 1e-9);
  EXPECT_NEAR(Bridged(100, 5, level, 0.0, 4e-4).inGap(2).sigma_z, 4e-4, 1e-9);
}

TEST(BridgeGaps, AWorseStationCountsForLess) {
  std::vector<StationDatum> stations = Bridged(100, 3, level).stations;
  stations[104].z += 0.010;
  const auto bridgedWith = [&](double sigma) {
    std::vector<StationDatum> copy = stations;
    copy[104].sigma_z = sigma;
    return bridgeGaps(copy, kCenter, 0.0)[101].z - 2.0;
  };
  EXPECT_GT(bridgedWith(1e-4), 3e-4);
  EXPECT_LT(bridgedWith(1e-2), 3e-6);
}

TEST(BridgeGaps, LeanOnStationsBesideTheGapOnly) {
  std::vector<StationDatum> stations = Bridged(100, 3, level).stations;
  stations[90].z += 0.010;   // eleventh from the middle
  stations[140].z += 1.000;  // far away
  const std::vector<StationDatum> near = bridgeGaps(stations, kCenter, 0.0);
  EXPECT_GT(std::abs(near[101].z - 2.0), 1e-5);
  stations[90].z = 2.0;
  stations = bridgeGaps(stations, kCenter, 0.0);
  EXPECT_NEAR(stations[101].z, 2.0, 1e-9);
}

TEST(BridgeGaps, ElevenDegreesStayMissingAndMeasuredStationsAreLeftAlone) {
  const Bridged bridged(100, 11, level, 0.003);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_EQ(bridged.inGap(i).flag, StationFlag::Missing);
    EXPECT_TRUE(std::isnan(bridged.inGap(i).z));
    EXPECT_TRUE(std::isnan(bridged.inGap(i).sigma_z));
  }
  EXPECT_EQ(bridged.stations[99].z, 2.0);
  EXPECT_EQ(bridged.stations[99].sigma_z, 1e-4);
}

TEST(BridgeGaps, ALoneStationBetweenTwoGapsCarriesBoth) {
  std::vector<StationDatum> stations = Bridged(100, 4, level).stations;
  stations[105].flag = stations[106].flag = StationFlag::Interpolated;  // 104 stands alone
  for (StationDatum& s : stations) s.z = s.flag == StationFlag::Measured ? s.z : NAN;
  stations = bridgeGaps(stations, kCenter, 0.003);
  for (const std::size_t i : {100U, 103U, 105U, 106U}) {
    EXPECT_NEAR(stations[i].z, 2.0, 1e-9) << i;
    EXPECT_TRUE(std::isfinite(stations[i].sigma_z)) << i;
  }
}

TEST(BridgeGaps, WhatIsMeasuredFarAwayDoesNotMoveThem) {
  // stations stand in every third degree of a dip, and far off a few on soil
  const auto dip = [](double t) { return 2.0 + 0.002 * std::cos(t / 2.0); };
  std::vector<StationDatum> stations = Bridged(100, 2, dip).stations;
  for (std::size_t i = 0; i < 360; ++i) {
    const bool is_soil = i >= 20 && i < 28, is_measured = is_soil || (i >= 90 && i < 120 && i % 3 == 0);
    stations[i].flag = is_measured ? StationFlag::Measured : StationFlag::Missing;
    if (is_soil) stations[i].z += 0.06;
  }
  stations[94].flag = StationFlag::Interpolated;
  stations[94].z = NAN;
  const double z = dip((94.0 - 100.5) * kStep);
  const StationDatum bridge = bridgeGaps(stations, kCenter, 0.001)[94];
  EXPECT_NEAR(bridge.z, z, 3e-4);
  EXPECT_LT(bridge.sigma_z, 3e-4);
  EXPECT_GT(std::abs(bridgeGaps(stations, kCenter, 0.0)[94].z - z), 1e-3);  // a parabola that is good for any distance
}

TEST(BridgeGaps, LeanOnTwelveStationsOnEitherSide) {
  const auto movedBy = [](int away) {  // of one station, raised by a centimetre
    const auto height = [=](double t) { return std::abs(t - away * kStep) < 0.5 * kStep ? 2.01 : 2.0; };
    return std::abs(Bridged(100, 1, height).inGap(0).z - 2.0);
  };
  EXPECT_GT(movedBy(12), 1e-4);
  EXPECT_GT(movedBy(-12), 1e-4);
  EXPECT_LT(movedBy(13), 1e-12);
}

}  // namespace tank_datum::gap_bridge_test
