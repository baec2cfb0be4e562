#include "setups/labelled_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/units.h"
#include "locate/crop.h"
#include "support/test_folder.h"

namespace tank_datum {
namespace {

constexpr int kDegrees = 360;
constexpr int kSetups = 4;  // each sees half of a shell
constexpr double kRadius = 10.0;

/// A point of the shell, one of a degree's.
struct Point {
  int degree;
  int setup;
  double height;
};

std::vector<Point> pointsOfShell() {
  std::vector<Point> points;
  for (int setup = 0; setup < kSetups; ++setup) {
    for (int i = 0; i < kDegrees / 2; ++i) {
      for (int k = 0; k < 8; ++k) points.push_back({(90 * setup + i) % kDegrees, setup, 0.3 + 0.02 * k});
    }
  }
  return points;
}

class LabelledTilesTest : public testing::Test {
 protected:
  /// Files of so many degrees each that reach so many degrees into the next, with the labels that label_of says.
  template <typename LabelOf>
  Scan filesOf(int width, int border, const LabelOf& label_of) const {
    std::vector<std::string> paths;
    for (int from = 0; from < kDegrees; from += width) {
      std::string text = "x y z setup\n";
      for (const Point& p : pointsOfShell()) {
        if ((p.degree - from + kDegrees) % kDegrees >= width + border) continue;
        const double a = toRadians(p.degree + 0.5);
        text += std::to_string(kRadius * std::cos(a)) + ' ' + std::to_string(kRadius * std::sin(a)) + ' ' +
                std::to_string(p.height) + ' ' + std::to_string(label_of(p, from)) + '\n';
      }
      paths.push_back(folder_.file("tile_" + std::to_string(from) + ".txt", text));
    }
    return Scan::open(paths);
  }

  static int setupOf(const Point& p, int) { return p.setup; }

  const TestFolder folder_;
};

/// The ring of a scan, all of its points, and the tank they are of.
struct Cropped {
  explicit Cropped(const Scan& of) : scan(of) {
    tank.circle = {-scan.origin().head<2>(), kRadius};
    tank.foot.coefficients = Eigen::Vector3d(-scan.origin().z(), 0.0, 0.0);
    ring = cropRing(scan, tank, {});
  }
  bool join() { return joinLabelledTiles(ring, SetupRing(ring, tank, 1), scan, tank); }

  const Scan& scan;
  Tank tank;
  Ring ring;
};

TEST_F(LabelledTilesTest, LabelsOfTilesNameTheSetups) {
  const Scan scan = filesOf(60, 2, setupOf);
  Cropped cropped(scan);
  ASSERT_EQ(cropped.ring.setups.size(), 16U);  // of six files, each holding two or three
  ASSERT_TRUE(cropped.join());
  ASSERT_EQ(cropped.ring.setups.size(), 4U);
  for (std::size_t i = 0; i < cropped.ring.points.size(); ++i) {
    const int setup = std::stoi(scan.setupLabel(cropped.ring.setups[cropped.ring.setupOf(i)]));
    const Eigen::Vector2d arm = cropped.ring.points[i].head<2>() - cropped.tank.circle.center;
    double azimuth = std::atan2(arm.y(), arm.x()) / kTwoPi * kDegrees - 90.0 * setup;
    azimuth -= kDegrees * std::floor(azimuth / kDegrees);
    ASSERT_LT(azimuth, kDegrees / 2) << setup;
  }
}

TEST_F(LabelledTilesTest, FilesThatSeeTheSameAreNoTiles) {
  const Scan scan = filesOf(90, 60, setupOf);
  EXPECT_FALSE(Cropped(scan).join()) << "a day's setups each, say";
}

TEST_F(LabelledTilesTest, LabelsThatNoTwoFilesShareStay) {
  const Scan scan = filesOf(60, 2, [](const Point& p, int from) { return 10 * from + p.setup; });
  EXPECT_FALSE(Cropped(scan).join());
}

TEST_F(LabelledTilesTest, OneLabelAlikeInAllFilesTellsNothing) {
  const Scan scan = filesOf(60, 2, [](const Point&, int) { return 7; });
  EXPECT_FALSE(Cropped(scan).join());
}

TEST_F(LabelledTilesTest, FilesOfOneLabelEachStay) {
  const Scan scan = filesOf(60, 2, [](const Point&, int from) { return from / 120; });
  EXPECT_FALSE(Cropped(scan).join()) << "numbered from 0 on in each of two days";
}

}  // namespace
}  // namespace tank_datum
