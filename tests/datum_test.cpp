#include "tank_datum/datum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "support/made_clouds.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum::datum_test {

using namespace made_clouds;

/// One run of the default chain on the whole tank, for the tests that look at it.
const Datum& wholeTank() {
  static const Datum datum = extractDatum(Scan::fromPoints(tankPoints()), {});
  return datum;
}

/// Elevation of a station in the scan's own frame.
double heightOf(const Datum& datum, std::size_t station) { return datum.stations[station].z + datum.origin.z(); }

TEST(ExtractDatum, OfAWholeTankIsOk) {
  const Datum& datum = wholeTank();
  EXPECT_EQ(datum.status, Status::Ok) << datum.message;
  EXPECT_TRUE(datum.usable());
  EXPECT_EQ(datum.message.find("scans of several setups are not told apart"), 0U) << "its points have no order";
  ASSERT_EQ(datum.stations.size(), 360U);
  EXPECT_EQ(datum.level.missing, 0U);
  EXPECT_EQ(datum.counts.points, tankPoints().size());
  EXPECT_EQ(datum.counts.invalid, 0U);
  EXPECT_NEAR(datum.circle.radius, kRadius, 0.03);
  EXPECT_NEAR((datum.circle.center + datum.origin.head<2>()).norm(), 0.0, 0.01);
}

TEST(ExtractDatum, ElevationsAreTheTruthWithinThePapersBias) {
  double bias = 0, squares = 0;
  for (const Station& s : wholeTank().stations)
    bias += (s.z_paper + wholeTank().origin.z() - elevation(s.direction)) / 360;
  EXPECT_GT(bias, 0.0);
  EXPECT_LT(bias, 0.035);  // grows with k and the spacing, 40 mm here
  for (const Station& s : wholeTank().stations) {
    squares += std::pow(s.z_paper + wholeTank().origin.z() - elevation(s.direction) - bias, 2) / 360;
    EXPECT_NEAR(s.z + wholeTank().origin.z(), elevation(s.direction), 0.035) << s.azimuth;
  }
  EXPECT_LT(std::sqrt(squares), 0.003);
}

TEST(ExtractDatum, FindsTheTiltThatWasMade) {
  const Tilt& tilt = wholeTank().tilt;
  EXPECT_NEAR(kRadius * tilt.slope(), 0.02, 0.001);
  EXPECT_NEAR(tilt.direction, 1.0, 0.05);
  EXPECT_LT(tilt.p_value, 1e-6);
  EXPECT_NEAR(wholeTank().antipodal.max_h, 0.04, 0.003);
  for (const Station& s : wholeTank().stations) ASSERT_NEAR(s.z_tilt + s.u, s.z, 1e-9);  // known of each
}

TEST(ExtractDatum, EdgePointsGoRoundTheTankNearTheCrease) {
  const Datum& datum = wholeTank();
  ASSERT_GT(datum.edge_points.size(), 1000U);
  for (const auto& p : datum.edge_points) {
    const Eigen::Vector3d own = p + datum.origin;
    EXPECT_NEAR(own.head<2>().norm(), kRadius, 0.15);
    EXPECT_NEAR(own.z(), elevation(std::atan2(own.y(), own.x())), 0.2);
  }
  EXPECT_LT(datum.curve.rms, 0.1);
  EXPECT_GT(datum.curve.check_points, 200U);
}

TEST(ExtractDatum, IsTheSameAtNationalCoordinates) {
  const Datum& near = wholeTank();
  const Eigen::Vector3d shift(512034.25, 4012877.5, 812.0);
  const Datum far = extractDatum(Scan::fromPoints(tankPoints(shift)), {});
  ASSERT_EQ(far.status, Status::Ok) << far.message;
  EXPECT_NEAR((far.circle.center + far.origin.head<2>() - shift.head<2>()).norm(), 0.0, 0.01);
  for (std::size_t i = 0; i < 360; ++i) {
    EXPECT_NEAR(heightOf(far, i) - shift.z(), heightOf(near, i), 1e-5) << i;
    const double up = far.origin.z() - near.origin.z() - shift.z();
    EXPECT_NEAR(far.stations[i].z_paper + up, near.stations[i].z_paper, 1e-5) << i;
  }
}

TEST(ExtractDatum, DoesNotDependOnTheNumberOfThreads) {
  DatumOptions options;
  const Scan scan = Scan::fromPoints(tankPoints());
  options.threads = 1;
  const Datum one = extractDatum(scan, options);
  options.threads = 2;
  const Datum two = extractDatum(scan, options);
  EXPECT_EQ(one.edge_points, two.edge_points);
  EXPECT_EQ(one.tilt.gradient, two.tilt.gradient);
  ASSERT_EQ(one.stations.size(), 360U);
  for (std::size_t i = 0; i < 360; ++i) {
    EXPECT_EQ(one.stations[i].z, two.stations[i].z);
    EXPECT_EQ(one.stations[i].radius, two.stations[i].radius);
  }
}

TEST(ExtractDatum, OfHalfATankIsPartialAndSaysWhatIsMissing) {
  const Datum datum = extractDatum(Scan::fromPoints(tankPoints({0, 0, 0}, kTurn / 2)), {});
  EXPECT_EQ(datum.status, Status::Partial) << datum.message;
  EXPECT_TRUE(datum.usable());
  EXPECT_NEAR(static_cast<double>(datum.level.missing), 180.0, 4.0);
  EXPECT_NE(datum.message.find("of 360 stations are missing"), std::string::npos) << datum.message;
  EXPECT_TRUE(std::isnan(datum.stations[270].z));
  EXPECT_NEAR(heightOf(datum, 90), elevation(kTurn / 4), 0.03);
}

TEST(ExtractDatum, TellsItsObserverEachStageInOrder) {
  std::vector<std::string> stages;
  extractDatum(Scan::fromPoints(tankPoints()), {}, {[&](const char* stage) { stages.push_back(stage); }, {}, {}});
  const std::vector<std::string> first = {"locate",         "crop",          "setups", "normals",
                                          "region_growing", "centre_filter", "spline"};
  ASSERT_GE(stages.size(), first.size());
  EXPECT_TRUE(std::equal(first.begin(), first.end(), stages.begin()));
}

TEST(ExtractDatum, TakesItsNormalsFromTheStageGiven) {
  DatumOptions options;
  options.method = Method::Paper;
  options.threads = 1;
  std::size_t asked = 0;
  Callbacks callbacks;
  callbacks.normals = [&](const Points& points, const NormalOptions& normals, int threads) {
    asked = points.size();
    EXPECT_EQ(threads, 1);
    Normals result = estimateNormals(points, normals, threads);
    for (auto& n : result.normals) n = Eigen::Vector3f::UnitZ();  // no crease
    return result;
  };
  const Datum datum = extractDatum(Scan::fromPoints(tankPoints()), options, callbacks);
  EXPECT_GT(asked, 10'000U);
  EXPECT_EQ(datum.status, Status::FitFailed) << datum.message;
  EXPECT_TRUE(datum.edge_points.empty());
}

TEST(ExtractDatum, OptionsReachTheirStages) {
  const Scan scan = Scan::fromPoints(tankPoints());
  const auto with = [&](const std::function<void(DatumOptions&)>& change) {
    DatumOptions options;
    change(options);
    return extractDatum(wholeTank().tank, scan, options);
  };
  const std::size_t edge = wholeTank().edge_points.size();
  EXPECT_GT(with([](auto& o) { o.normals.k = 40; }).edge_points.size(), edge);
  EXPECT_LT(with([](auto& o) { o.growing.angle = 0.9; }).edge_points.size(), edge);
  EXPECT_LT(with([](auto& o) { o.centre_filter.tolerance = 0.01; }).edge_points.size(), edge);
  EXPECT_EQ(with([](auto& o) { o.spline.control_points = 50; }).curve.control_points.rows(), 50);
  EXPECT_EQ(with([](auto& o) { o.stations.count = 36; }).stations.size(), 36U);
  EXPECT_LT(with([](auto& o) { o.crop.reach = 0.02; }).edge_points.size(), edge);
}

TEST(ExtractDatum, OfAShellWithoutAFoundationFindsNoCrease) {
  Points shell;
  for (const auto& p : tankPoints()) {
    if (p.head<2>().norm() < kRadius + 0.004) shell.push_back(p);
  }
  const Datum datum = extractDatum(Scan::fromPoints(shell), {});
  EXPECT_EQ(datum.status, Status::NoCrease) << datum.message;
  EXPECT_NEAR(datum.tank.circle.radius, kRadius, 0.03);
  EXPECT_TRUE(datum.stations.empty());
}

TEST(ExtractDatum, WithoutEdgePointsTheFitFails) {
  DatumOptions options;
  options.method = Method::Paper;
  options.growing.angle = 1.57;
  const Datum datum = extractDatum(wholeTank().tank, Scan::fromPoints(tankPoints()), options);
  EXPECT_EQ(datum.status, Status::FitFailed) << datum.message;
  EXPECT_FALSE(datum.usable());
}

TEST(ExtractDatum, OfARingWithFewerPointsThanNeighboursHasTooFew) {
  const Datum datum = extractDatum(wholeTank().tank, Scan::fromPoints({{kRadius, 0, 0.5}, {0, kRadius, 0.5}}), {});
  EXPECT_EQ(datum.status, Status::TooFewPoints) << datum.message;
}

TEST(ExtractDatum, OfAFloorOrARoomFindsNoTank) {
  for (const Points& points : {floorPoints(50'000, 8.0), roomPoints()}) {
    const Datum datum = extractDatum(Scan::fromPoints(points), {});
    EXPECT_EQ(datum.status, Status::NoTank) << datum.message;
    EXPECT_FALSE(datum.usable());
    EXPECT_FALSE(datum.message.empty());
    EXPECT_TRUE(datum.stations.empty());
    EXPECT_TRUE(std::isnan(datum.level.mean));
    EXPECT_EQ(datum.counts.points, points.size());
  }
}

TEST(ExtractDatum, OfFewerPointsThanNeighboursHasTooFew) {
  for (const unsigned count : {0U, 1U, 3U, 19U}) {
    const Datum datum = extractDatum(Scan::fromPoints(floorPoints(static_cast<int>(count), 8.0)), {});
    EXPECT_EQ(datum.status, Status::TooFewPoints) << count;
    EXPECT_FALSE(datum.message.empty());
    EXPECT_EQ(datum.counts.points, count);
  }
  EXPECT_EQ(extractDatum(Scan::fromPoints(floorPoints(20, 8.0)), {}).status, Status::NoTank);
  const Datum invalid = extractDatum(Scan::fromPoints(Points(100, {NAN, 0, 0})), {});
  EXPECT_EQ(invalid.status, Status::TooFewPoints);
  EXPECT_EQ(invalid.counts.invalid, 100U);
}

TEST(Datum, SaysThatItWasNotRun) {
  EXPECT_EQ(Datum().status, Status::NotRun);
  EXPECT_FALSE(Datum().usable());
}

TEST(DatumOptions, AreRefusedByNameAndThrown) {
  EXPECT_EQ(said(firstError(DatumOptions())), "");
  const std::vector<std::pair<std::string, std::function<void(DatumOptions&)>>> cases = {
      {"min_radius, 0", [](auto& o) { o.locate.min_radius = 0; }},
      {"locate.min_arc_deg, 401.07", [](auto& o) { o.locate.min_arc = 7; }},
      {"locate.sample_points, 10", [](auto& o) { o.locate.sample_points = 10; }},
      {"crop.reach, -1", [](auto& o) { o.crop.reach = -1; }},
      {"k, 2", [](auto& o) { o.normals.k = 2; }},
      {"angle_deg, 114.592", [](auto& o) { o.growing.angle = 2; }},
      {"centre_tolerance, -1", [](auto& o) { o.centre_filter.tolerance = -1; }},
      {"control_points, 1", [](auto& o) { o.spline.control_points = 1; }},
      {"stations, 3", [](auto& o) { o.stations.count = 3; }},
      {"tank, 0,0,-2",
       [](auto& o) {
         o.tank = Circle{{0, 0}, -2};
       }},
      {"threads, -1", [](auto& o) { o.threads = -1; }},
  };
  const Scan scan = Scan::fromPoints({});
  for (const auto& [message, change] : cases) {
    DatumOptions options;
    change(options);
    EXPECT_EQ(said(firstError(options)).rfind(message, 0), 0U) << said(firstError(options));
    try {
      extractDatum(scan, options);
      ADD_FAILURE() << message << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::Option);
      EXPECT_EQ(std::string(error.what()).rfind("options: " + message, 0), 0U) << error.what();
    }
  }
}

}  // namespace tank_datum::datum_test
