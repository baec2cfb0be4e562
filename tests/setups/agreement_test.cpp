#include "setups/agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/pcd_writer.h"
#include "locate/crop.h"
#include "setups/setup_report.h"
#include "support/scanned_tanks.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"

namespace tank_datum::agreement_test {

using namespace scanned_tanks;

/// Rows so close that two setups see the same parts of the foundation where both see it: 3 cm apart on it.
SceneOptions closeRows() {
  SceneOptions scene = tank20();
  scene.scanner.row_step = radians(0.02);
  return scene;
}

SetupAgreement agreed(Ring& ring, const Scan& scan, const Tank& tank, const SetupOptions& options) {
  const RepeatedPoints repeated = removeRepeated(ring);
  return agreeSetups(ring, repeated, scan, tank, options);
}

/// Four setups of a small tank, one file each, each with an error of its own.
class SetupAgreementTest : public testing::Test {
 protected:
  /// Scans the scene, and puts dz on each setup's points. Their scanners are said to have stood so far off their place.
  std::vector<std::string> filesOf(const SceneOptions& scene, const std::vector<double>& dz, double off = 0.0) const {
    const auto stations = synth::scanStations(synth::Scene(scene));
    std::vector<std::vector<double>> rows(stations.size());
    synth::scanScene(synth::Scene(scene), [&](std::size_t s, const synth::Rows& block) {
      for (std::size_t i = 0; i < block.size() / 4; ++i) {
        rows[s].insert(rows[s].end(), {block[4 * i], block[4 * i + 1], block[4 * i + 2] + dz[s]});
      }
    });
    std::vector<std::string> paths;
    for (std::size_t s = 0; s < rows.size(); ++s) {
      paths.push_back(folder_.path("scan_" + std::to_string(s + 1) + ".pcd"));
      const Eigen::Vector3d& at = stations[s].position;
      PcdWriter writer(paths.back(), {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}}, PcdWriter::Format::Binary,
                       {"", {at.x() + off, at.y(), at.z() + dz[s]}});
      writer.append(rows[s]);
      writer.commit();
    }
    return paths;
  }

  const TestFolder folder_;
};

TEST_F(SetupAgreementTest, HeightsThatDisagreeAreFoundAndTakenOut) {
  const std::vector<double> dz = {0.003, -0.001, 0.002, -0.004};
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open(filesOf(scene, dz));
  const Tank tank = roughTank(scene, scan.origin());
  Ring ring = cropRing(scan, tank, {});
  ASSERT_EQ(ring.setupCount(), 4U);
  EXPECT_TRUE(ring.search.empty());
  const Points before = ring.points;
  const SetupAgreement agreement = agreed(ring, scan, tank, {});
  ASSERT_EQ(agreement.setups.size(), 4U);
  EXPECT_EQ(agreement.setups[1].name, "scan_2");
  EXPECT_TRUE(agreement.setups[1].origin_known);
  // the mean of all is not seen, the differences are; a tilt of a tenth of an arc-minute may take a part of them
  const auto lift = [&](std::size_t s) {
    const tank_datum::Setup& setup = agreement.setups[s];
    const Eigen::Vector2d foot = tank.circle.center - setup.origin.head<2>();
    const Eigen::Vector2d near = foot.normalized() * (foot.norm() - tank.circle.radius);
    return setup.correction.dz + setup.correction.tilt_x * near.x() + setup.correction.tilt_y * near.y();
  };
  EXPECT_NEAR(lift(3) - lift(0), 0.007, 0.0012);
  EXPECT_NEAR(lift(2) - lift(1), -0.003, 0.0012);
  EXPECT_GT(agreement.rms_before, 0.002);
  EXPECT_LT(agreement.rms_after, 0.0004);
  EXPECT_NE(ring.points, before);
}

TEST_F(SetupAgreementTest, AgreeingSetupsStayAndBarelyWidenSigma) {
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open(filesOf(scene, {0, 0, 0, 0}));
  const Tank tank = roughTank(scene, scan.origin());
  Ring ring = cropRing(scan, tank, {});
  const SetupAgreement agreement = agreed(ring, scan, tank, {});
  for (const tank_datum::Setup& setup : agreement.setups) {
    EXPECT_LT(std::abs(setup.correction.dz), 0.0003) << setup.name;
    EXPECT_NE(setup.verdict, SetupVerdict::Bad) << setup.name;
  }
  EXPECT_LT(agreement.spread.height, 0.0005);
  EXPECT_EQ(setupMessage(agreement, {}), "");
}

TEST_F(SetupAgreementTest, AFileGivenTwiceIsUsedOnceAndSaid) {
  const SceneOptions scene = closeRows();
  std::vector<std::string> paths = filesOf(scene, {0, 0, 0, 0});
  const Scan once = Scan::open(paths);
  const Tank tank = roughTank(scene, once.origin());
  const std::size_t points = cropRing(once, tank, {}).points.size();
  const std::string again = folder_.path("again.pcd");
  std::filesystem::copy_file(paths[0], again);
  paths.push_back(again);
  const Scan scan = Scan::open(paths);
  Ring ring = cropRing(scan, tank, {});
  const SetupAgreement agreement = agreed(ring, scan, tank, {});
  EXPECT_EQ(ring.points.size(), points);
  EXPECT_EQ(agreement.setups[4].verdict, SetupVerdict::Duplicate);
  EXPECT_NE(setupMessage(agreement, {}).find("setup again holds the points of another one"), std::string::npos);
}

TEST_F(SetupAgreementTest, TheBadOneCanBeDroppedWhereOthersSeeTheFoot) {
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open(filesOf(scene, {0, 0.015, 0, 0}));
  const Tank tank = roughTank(scene, scan.origin());
  Ring ring = cropRing(scan, tank, {}), freed = ring;
  SetupOptions options;
  const SetupAgreement agreement = agreed(freed, scan, tank, options);
  EXPECT_EQ(agreement.setups[1].verdict, SetupVerdict::Bad);
  EXPECT_EQ(freed.points.size(), ring.points.size());
  options.bad = BadSetups::Drop;
  agreed(ring, scan, tank, options);
  EXPECT_LT(ring.points.size(), freed.points.size());
  EXPECT_EQ(ring.points.size(), ring.point_setups.size());
}

TEST_F(SetupAgreementTest, OriginsOfNoSetupAreRefused) {
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open(filesOf(scene, {0, 0, 0, 0}));
  const Tank tank = roughTank(scene, scan.origin());
  SetupOptions options;
  options.origins["scan_9"] = {1.0, 2.0, 3.0};
  Ring ring = cropRing(scan, tank, {});
  EXPECT_THROW(agreed(ring, scan, tank, options), Error);
  options.origins = {{"scan_2", scan.origin() + Eigen::Vector3d(1.0, 2.0, 3.0)}};
  EXPECT_EQ(agreed(ring, scan, tank, options).setups[1].origin, Eigen::Vector3d(1.0, 2.0, 3.0));
}

TEST_F(SetupAgreementTest, OriginsTooFarFromTheTankAreRefused) {
  const SceneOptions scene = closeRows();
  const double radius = scene.tanks[0].radius;
  const Scan scan = Scan::open(filesOf(scene, {0, 0, 0, 0}));
  const Tank tank = roughTank(scene, scan.origin());
  const Ring ring = cropRing(scan, tank, {});
  const auto agreedFrom = [&](double radii) {
    SetupOptions options;
    options.origins = {{"scan_2", scan.origin() + Eigen::Vector3d(radii * radius, 0.0, 0.0)}};
    Ring copy = ring;
    return agreed(copy, scan, tank, options);
  };
  EXPECT_TRUE(agreedFrom(60.0).setups[1].origin_known);
  try {
    agreedFrom(150.0);
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("100 radii of the tank or less"), std::string::npos) << error.what();
  }
}

TEST_F(SetupAgreementTest, PlacesInAnotherFrameAreTakenAsUnknown) {
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open(filesOf(scene, {0.003, -0.001, 0.002, -0.004}, 512000.0));
  const Tank tank = roughTank(scene, scan.origin());
  Ring ring = cropRing(scan, tank, {});
  const SetupAgreement agreement = agreed(ring, scan, tank, {});
  EXPECT_FALSE(agreement.setups[1].origin_known);
  EXPECT_LT(agreement.setups[1].sigma.dz, 0.01);
  EXPECT_LT(agreement.rms_after, 0.0004);
  const std::string said = setupMessage(agreement, {});
  EXPECT_NE(said.find("and 3 more cannot have stood where the file says, 5120"), std::string::npos) << said;
}

TEST_F(SetupAgreementTest, ARingOfOneSetupIsLeftAsItIs) {
  const SceneOptions scene = closeRows();
  const Scan scan = Scan::open({filesOf(scene, {0, 0, 0, 0})[0]});
  const Tank tank = roughTank(scene, scan.origin());
  Ring ring = cropRing(scan, tank, {});
  EXPECT_TRUE(ring.point_setups.empty());
  EXPECT_FALSE(ring.search.empty());
  const Points before = ring.points;
  const SetupAgreement agreement = agreed(ring, scan, tank, {});
  EXPECT_EQ(ring.points, before);
  EXPECT_FALSE(agreement.adjusted());
  ASSERT_EQ(agreement.setups.size(), 1U);
  EXPECT_EQ(agreement.setups[0].verdict, SetupVerdict::Single);
}

TEST(SetupAgreement, PointsThatAreNotMovedErrAsBadSetupsDo) {
  SetupAgreement agreement;
  agreement.setups.resize(3);
  agreement.covariance = Eigen::MatrixXd::Identity(5, 5);
  agreement.spread = {0.002, 0.0001, 0.003};
  agreement.setups[1].correction = SetupMotion{-0.009, 0.0003, 0.0004, 0.03, 0.04};
  EXPECT_DOUBLE_EQ(agreement.errorsOfPoints().plan, 0.003) << "which stand as the others do";
  agreement.setups[1].verdict = SetupVerdict::Bad;
  EXPECT_DOUBLE_EQ(agreement.errorsOfPoints().height, 0.009);
  EXPECT_DOUBLE_EQ(agreement.errorsOfPoints().tilt, 0.0005);
  EXPECT_DOUBLE_EQ(agreement.errorsOfPoints().plan, 0.05);
  EXPECT_DOUBLE_EQ(agreement.errorsOfOne().plan, 0.003);
}

TEST(SetupAgreement, PlacesMakeARadiusOfWhatNoOverlapShows) {
  SetupAgreement agreement;
  agreement.setups.resize(5);
  for (std::size_t s = 0; s < 4; ++s) agreement.setups[s].stations = 90;
  agreement.spread.plan = 0.003;
  EXPECT_EQ(agreement.errorsOfOne().plan, 0.0) << "not adjusted, one setup";
  agreement.covariance = Eigen::MatrixXd::Identity(5, 5);
  EXPECT_DOUBLE_EQ(agreement.errorsOfOne().plan, 0.003);
  EXPECT_DOUBLE_EQ(agreement.radiusError(), 0.0015) << "of the four that see the foot";
  SetupAgreement merged;
  merged.merged_sigma = 0.0028;
  EXPECT_DOUBLE_EQ(merged.radiusError(), 0.0028);
}

/// The agreement of points of a shell that bear so many labels, two of each: too few to compare.
SetupAgreement agreementOfLabels(std::size_t labels) {
  const TestFolder folder;
  std::string text = "x y z setup\n";
  for (std::size_t i = 0; i < 2 * labels; ++i) {
    const double azimuth = 0.01 * static_cast<double>(i);
    text += std::to_string(5.0 * std::cos(azimuth)) + " " + std::to_string(5.0 * std::sin(azimuth)) + " 0.2 " +
            std::to_string(i % labels) + "\n";
  }
  const Scan scan = Scan::open({folder.file("scan.txt", text)});
  Tank tank;
  tank.circle = {-scan.origin().head<2>(), 5.0};
  tank.foot.coefficients = Eigen::Vector3d(-scan.origin().z(), 0.0, 0.0);
  Ring ring = cropRing(scan, tank, {});
  return agreed(ring, scan, tank, {});
}

TEST(SetupAgreement, MoreThanTwoHundredLabelsAreTakenTogetherAndSaid) {
  const std::string told = "more than 200 files or labels are not told apart";
  EXPECT_EQ(setupMessage(agreementOfLabels(200), {}).find(told), std::string::npos);
  const SetupAgreement many = agreementOfLabels(201);
  ASSERT_EQ(many.setups.size(), 1U);
  EXPECT_EQ(many.setups[0].name, "all");
  EXPECT_EQ(setupMessage(many, {}), told);
}

}  // namespace tank_datum::agreement_test
