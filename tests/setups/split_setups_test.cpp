#include "setups/split_setups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/units.h"
#include "locate/crop.h"
#include "support/test_folder.h"

namespace tank_datum::split_setups_test {

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

class SplitSetupsTest : public testing::Test {
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

  /// Two files over each of which the points of two setups, a half of a shell each, are dealt out; so many of a degree.
  /// @param file_of   of the n-th point
  /// @param label_of  of a file's point; below 0 there is none
  /// @param apart     of the places where the files say that they were scanned from [m]
  /// @param raised    the second file's foundation, rough by 1 mm [m]
  template <typename FileOf, typename LabelOf>
  Scan dealt(int of_degree, const FileOf& file_of, const LabelOf& label_of, double apart = 0.0, double raised = 0.0) {
    std::string rows[2];
    int counts[2] = {0, 0};
    const bool labelled = label_of(0, 0) >= 0;
    std::mt19937_64 random(4);
    std::normal_distribution<double> rough(0.0, 0.001);
    for (int n = 0; n < kDegrees * of_degree; ++n) {
      const int setup = n / (kDegrees / 2 * of_degree), file = file_of(n);
      const double degree = static_cast<double>(n) / of_degree;
      const auto add = [&](double radius, double z) {
        rows[file] += std::to_string(radius * std::cos(toRadians(degree))) + ' ' +
                      std::to_string(radius * std::sin(toRadians(degree))) + ' ' + std::to_string(z);
        rows[file] += labelled ? ' ' + std::to_string(label_of(setup, file)) + '\n' : "\n";
        ++counts[file];
      };
      add(kRadius, 0.3 + 0.001 * (n % 50));
      if (n % 4 == 0) add(kRadius + 0.05 + 0.3 * std::fmod(0.618034 * n, 1.0), rough(random) + file * raised);
    }
    std::vector<std::string> paths;
    for (int file = 0; file < 2; ++file) {
      const std::string points = std::to_string(counts[file]);
      const std::string fields = labelled ? "FIELDS x y z setup\nSIZE 8 8 8 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
                                          : "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\n";
      const std::string head = fields + "WIDTH " + points + "\nHEIGHT 1\nVIEWPOINT " +
                               std::to_string(20.0 + file * apart) + " 0 1 1 0 0 0\nPOINTS " + points +
                               "\nDATA ascii\n";
      paths.push_back(folder_.file("share_" + std::to_string(made_++) + ".pcd", head + rows[file]));
    }
    return Scan::open(paths);
  }

  static int setupOf(const Point& p, int) { return p.setup; }

  const TestFolder folder_;
  int made_ = 0;
};

/// The ring of a scan, all of its points, and the tank they are of.
struct Cropped {
  explicit Cropped(const Scan& of) : scan(of) {
    tank.circle = {-scan.origin().head<2>(), kRadius};
    tank.foot.coefficients = Eigen::Vector3d(-scan.origin().z(), 0.0, 0.0);
    ring = cropRing(scan, tank, {});
  }
  SplitSetups join() {
    const SetupRing polar(ring, tank, 1);
    const auto views = [&] {
      return viewArcs(polar, tank, ring.reach,
                      std::vector<Eigen::Vector3d>(ring.setups.size(), Eigen::Vector3d::Zero()), {}, 1);
    };
    return joinSplitSetups(ring, shellArcsOfSetups(polar, tank, ring.reach, ring.setups.size()), scan, views);
  }

  const Scan& scan;
  Tank tank;
  Ring ring;
};

TEST_F(SplitSetupsTest, LabelsOfTilesNameTheSetups) {
  const Scan scan = filesOf(60, 2, setupOf);
  Cropped cropped(scan);
  ASSERT_EQ(cropped.ring.setups.size(), 16U);  // of six files, each holding two or three
  ASSERT_EQ(cropped.join(), SplitSetups::ByLabel);
  ASSERT_EQ(cropped.ring.setups.size(), 4U);
  for (std::size_t i = 0; i < cropped.ring.points.size(); ++i) {
    const int setup = std::stoi(scan.setupLabel(cropped.ring.setups[cropped.ring.setupOf(i)]));
    const Eigen::Vector2d arm = cropped.ring.points[i].head<2>() - cropped.tank.circle.center;
    double azimuth = std::atan2(arm.y(), arm.x()) / kTwoPi * kDegrees - 90.0 * setup;
    azimuth -= kDegrees * std::floor(azimuth / kDegrees);
    ASSERT_LT(azimuth, kDegrees / 2) << setup;
  }
}

TEST_F(SplitSetupsTest, FilesThatSeeTheSameAreNoTiles) {
  const Scan scan = filesOf(90, 60, setupOf);
  EXPECT_EQ(Cropped(scan).join(), SplitSetups::None) << "a day's setups each, say";
}

/// Between 0 and 1, by a hash of a number (SplitMix64): the same whatever ran before.
double chance(int n) {
  std::uint64_t x = static_cast<std::uint64_t>(n + 1) * 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<double>((x ^ (x >> 31U)) >> 11U) / static_cast<double>(1ULL << 53U);
}

int byChance(int n) { return chance(n) < 0.5 ? 0 : 1; }
int likeTheOther(int setup, int) { return setup; }
int unlikeTheOther(int setup, int file) { return 10 * file + setup; }

TEST_F(SplitSetupsTest, PointsDealtOutToFilesAreOfTheSetupsThatLabelsName) {
  const Scan scan = dealt(16, byChance, likeTheOther);
  Cropped cropped(scan);
  ASSERT_EQ(cropped.ring.setups.size(), 4U);
  EXPECT_EQ(cropped.join(), SplitSetups::ByLabel);
  EXPECT_EQ(cropped.ring.setups.size(), 2U);
  const Scan sparse = dealt(6, byChance, likeTheOther);
  EXPECT_EQ(Cropped(sparse).join(), SplitSetups::None) << "15 points to an arc tell no setups apart";
}

/// Four thousand points of the shell to each.
TEST_F(SplitSetupsTest, PointsDealtOutToFilesAreOfOneSetupWhereTheyAreDense) {
  const Scan sparse = dealt(40, byChance, unlikeTheOther), dense = dealt(55, byChance, unlikeTheOther);
  EXPECT_EQ(Cropped(sparse).join(), SplitSetups::None);
  Cropped cropped(dense);
  EXPECT_EQ(cropped.join(), SplitSetups::ByDensity);
  ASSERT_EQ(cropped.ring.setups.size(), 2U);
  const std::uint16_t first = cropped.ring.setupOf(0);
  for (std::size_t i = 0; i < cropped.ring.points.size(); ++i) {
    const double y = cropped.ring.points[i].y() + dense.origin().y();
    if (std::abs(y) > 0.01) {
      ASSERT_EQ(cropped.ring.setupOf(i) == first, y > 0.0) << i;
    }
  }
}

TEST_F(SplitSetupsTest, FilesThatShowMoreHereAndLessThereAreSetupsOfTheirOwn) {
  const auto unevenly = [](double more) {
    return [more](int n) {
      const bool here = n / (130 * 5) % 2 == 0;  // five degrees here, five there
      return chance(n) < (here ? 0.5 + more : 0.5 - more) ? 1 : 0;
    };
  };
  const Scan chance = dealt(130, unevenly(0.015), unlikeTheOther), other = dealt(130, unevenly(0.04), unlikeTheOther);
  EXPECT_EQ(Cropped(chance).join(), SplitSetups::ByDensity);
  EXPECT_EQ(Cropped(other).join(), SplitSetups::None);
}

TEST_F(SplitSetupsTest, SetupsAtOnePlaceThatDifferInHeightAreTwo) {
  const auto none = [](int, int) { return -1; };
  const Scan chance = dealt(70, byChance, none, 0.0, 0.00009), other = dealt(70, byChance, none, 0.0, 0.0002);
  EXPECT_EQ(Cropped(chance).join(), SplitSetups::ByDensity) << "some standard errors";
  EXPECT_EQ(Cropped(other).join(), SplitSetups::None);
  const Scan labelled = dealt(70, byChance, likeTheOther, 0.0, 0.0006);
  EXPECT_EQ(Cropped(labelled).join(), SplitSetups::None);
}

TEST_F(SplitSetupsTest, FilesScannedFromOtherPlacesAreSetupsOfTheirOwn) {
  const auto none = [](int, int) { return -1; };
  const Scan one = dealt(70, byChance, none, 0.4), two = dealt(70, byChance, none, 0.6);
  EXPECT_EQ(Cropped(one).join(), SplitSetups::ByDensity);
  EXPECT_EQ(Cropped(two).join(), SplitSetups::None);
}

TEST_F(SplitSetupsTest, LabelsThatNoTwoFilesShareStay) {
  const Scan scan = filesOf(60, 2, [](const Point& p, int from) { return 10 * from + p.setup; });
  EXPECT_EQ(Cropped(scan).join(), SplitSetups::None);
}

TEST_F(SplitSetupsTest, OneLabelAlikeInAllFilesTellsNothing) {
  const Scan scan = filesOf(60, 2, [](const Point&, int) { return 7; });
  EXPECT_EQ(Cropped(scan).join(), SplitSetups::None);
}

TEST_F(SplitSetupsTest, FilesOfOneLabelEachStay) {
  const Scan scan = filesOf(60, 2, [](const Point&, int from) { return from / 120; });
  EXPECT_EQ(Cropped(scan).join(), SplitSetups::None) << "numbered from 0 on in each of two days";
}

}  // namespace tank_datum::split_setups_test
