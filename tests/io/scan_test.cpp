#include "tank_datum/io/scan.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cmath>
#include <stdexcept>

#include "support/pcd_files.h"

namespace tank_datum::scan_test {

using pcd_files::errorOf;
using pcd_files::Field;
using pcd_files::Folder;
using pcd_files::Row;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const std::vector<std::string> kEncodings = {"ascii", "binary", "binary_compressed"};

struct Pass {
  ScanCounts counts;
  Points points;  // in the scan's own frame: the origin added back
};

Pass passOf(const Scan& scan) {
  Pass pass;
  pass.counts = scan.forEachBlock([&](const Points& block) {
    EXPECT_FALSE(block.empty());
    for (const Eigen::Vector3d& p : block) pass.points.push_back(p + scan.origin());
  });
  return pass;
}

Pass passOf(const std::string& path) { return passOf(Scan::open({path})); }

void expectPoints(const Points& points, const Points& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(points[i], expected[i]) << i;
}

class ScanEncoding : public testing::TestWithParam<std::string> {
 protected:
  std::string file(const std::vector<Field>& fields, const std::vector<Row>& rows) const {
    return folder_.file("a.pcd", pcd_files::pcd(fields, rows, GetParam()));
  }
  Folder folder_;
};
INSTANTIATE_TEST_SUITE_P(All, ScanEncoding, testing::ValuesIn(kEncodings), pcd_files::nameOfEncoding);

TEST_P(ScanEncoding, EveryTypeOfEveryAxis) {
  const std::vector<Field> types = {{"", 'F', 4}, {"", 'F', 8}, {"", 'I', 1}, {"", 'I', 2}, {"", 'I', 4},
                                    {"", 'I', 8}, {"", 'U', 1}, {"", 'U', 2}, {"", 'U', 4}, {"", 'U', 8}};
  for (const Field& a : types) {
    for (const Field& b : types) {
      const bool negative = a.type != 'U' && b.type != 'U';
      const double x = negative ? -100 : 100;
      const std::vector<Field> fields = {{"x", a.type, a.size}, {"y", b.type, b.size}, {"z", a.type, a.size}};
      expectPoints(passOf(file(fields, {{x, 2, 3}, {4, x, 127}})).points, {{x, 2, 3}, {4, x, 127}});
    }
  }
}

TEST_P(ScanEncoding, FieldsInAnyOrderAmongOthers) {
  const std::vector<Field> fields = {{"label", 'U', 1}, {"z", 'F', 8}, {"histogram", 'F', 4, 3},
                                     {"x", 'I', 2},     {"_", 'U', 1}, {"y", 'F', 4}};
  const std::string path = file(fields, {{9, 3.25, 7, 7, 7, 1, 8, 2.5}, {9, 30.5, 7, 7, 7, -10, 8, 20}});
  expectPoints(passOf(path).points, {{1, 2.5, 3.25}, {-10, 20, 30.5}});
}

TEST_P(ScanEncoding, GeoreferencedDoublesAreExact) {
  const std::vector<Field> fields = {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}};
  const Points points = {{289814.151234567, 4320978.612345678, 170.7612345678901}, {289814.1512, 4320979.06, 170.75}};
  const Scan scan =
      Scan::open({file(fields, {{points[0].x(), points[0].y(), points[0].z()}, {289814.1512, 4320979.06, 170.75}})});
  EXPECT_EQ(scan.origin(), points[0]);
  expectPoints(passOf(scan).points, points);
  scan.forEachBlock([](const Points& block) { EXPECT_LT(block[0].cwiseAbs().maxCoeff(), 0.5); });
}

TEST_P(ScanEncoding, NotFiniteRowsAreDroppedAndCounted) {
  const std::string path =
      file(pcd_files::kXyzFloat, {{kNan, 0, 0}, {1, 2, 3}, {0, kInf, 0}, {0, 0, -kInf}, {0, 0, -kNan}, {4, 5, 6}});
  const Pass pass = passOf(path);
  EXPECT_EQ(pass.counts.points, 6U);
  EXPECT_EQ(pass.counts.invalid, 4U);
  expectPoints(pass.points, {{1, 2, 3}, {4, 5, 6}});
}

TEST_P(ScanEncoding, FirstFinitePointFarBehind) {
  std::vector<Row> rows(70000, Row{kNan, kNan, kNan});
  rows.push_back({1000.4, 2000.6, -30.5});
  const Scan scan = Scan::open({file(pcd_files::kXyzFloat, rows)});
  EXPECT_LT((scan.origin() - Eigen::Vector3d(1000.4, 2000.6, -30.5)).norm(), 1e-3);
  const Pass pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 70001U);
  EXPECT_EQ(pass.counts.invalid, 70000U);
  EXPECT_EQ(pass.points.size(), 1U);
}

TEST_P(ScanEncoding, NoFinitePointAndNoPointAtAll) {
  const Scan nan = Scan::open({file(pcd_files::kXyzFloat, {{kNan, 1, 1}})});
  EXPECT_EQ(nan.origin(), Eigen::Vector3d::Zero());
  EXPECT_EQ(passOf(nan).counts.invalid, 1U);
  const Scan none = Scan::open({folder_.file("b.pcd", pcd_files::header(pcd_files::kXyzFloat, 0, GetParam()))});
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(passOf(none).counts.points, 0U);
}

TEST_P(ScanEncoding, UnitsScaleBeforeTheOrigin) {
  const Scan scan = Scan::open({file(pcd_files::kXyzFloat, {{12300, -4600, 500}, {12301, -4600, 500}})}, 0.001);
  EXPECT_LT((scan.origin() - Eigen::Vector3d(12.3, -4.6, 0.5)).norm(), 1e-12);
  scan.forEachBlock([](const Points& block) {
    EXPECT_NEAR(block[0].norm(), 0.0, 1e-12);
    EXPECT_NEAR(block[1].x() - block[0].x(), 0.001, 1e-12);
  });
}

TEST_P(ScanEncoding, ManyBlocksInOrderTwice) {
  std::vector<Row> rows;
  for (int i = 0; i < 200000; ++i) rows.push_back({static_cast<double>(i), i % 3 == 0 ? kNan : 1, 2});
  const Scan scan = Scan::open({file(pcd_files::kXyzFloat, rows)});
  for (int pass_number = 0; pass_number < 2; ++pass_number) {
    const Pass pass = passOf(scan);
    EXPECT_EQ(pass.counts.invalid, 66667U);
    ASSERT_EQ(pass.points.size(), 133333U);
    for (std::size_t i = 0; i < pass.points.size(); ++i) {
      ASSERT_EQ(pass.points[i].x(), static_cast<double>(i / 2 * 3 + 1 + i % 2));
    }
  }
}

TEST_P(ScanEncoding, AsPclReadsIt) {
  pcl::PointCloud<pcl::PointXYZI> cloud;
  for (int i = 0; i < 50000; ++i) {
    const auto t = static_cast<float>(i);
    cloud.emplace_back(std::sin(t) * 12.3f, std::cos(t) * 12.3f, 1e-4f * t, 0.5f * t);
  }
  cloud[17].x = cloud[17].y = std::numeric_limits<float>::quiet_NaN();
  const std::string path = folder_.path("pcl.pcd");
  if (GetParam() == "ascii") {
    pcl::io::savePCDFileASCII(path, cloud);
  } else if (GetParam() == "binary") {
    pcl::io::savePCDFileBinary(path, cloud);
  } else {
    pcl::io::savePCDFileBinaryCompressed(path, cloud);
  }
  pcl::PointCloud<pcl::PointXYZI> oracle;
  ASSERT_EQ(pcl::PCDReader().read(path, oracle), 0);
  const Pass pass = passOf(path);
  EXPECT_EQ(pass.counts.points, oracle.size());
  EXPECT_EQ(pass.counts.invalid, 1U);
  std::size_t at = 0;
  for (const auto& p : oracle) {
    if (!std::isfinite(p.x)) continue;
    // text has more digits than a float holds: they agree as floats
    ASSERT_EQ(pass.points[at++].cast<float>(), p.getVector3fMap());
  }
}

TEST_P(ScanEncoding, VisitorMayThrow) {
  const Scan scan = Scan::open({file(pcd_files::kXyzFloat, {{1, 2, 3}})});
  EXPECT_THROW(scan.forEachBlock([](const Points&) { throw std::logic_error("enough"); }), std::logic_error);
  EXPECT_EQ(passOf(scan).points.size(), 1U);
}

TEST(Scan, SeveralFilesAreOneStream) {
  const Folder folder;
  const auto make = [&](const std::string& name, const std::string& data, double x) {
    return folder.file(name, pcd_files::pcd(pcd_files::kXyzFloat, {{kNan, 0, 0}, {x, 0, 0}}, data));
  };
  const std::string nan = folder.file("0.pcd", pcd_files::pcd(pcd_files::kXyzFloat, {{kNan, 0, 0}}, "ascii"));
  const std::vector<std::string> paths = {nan, make("1.pcd", "binary", 5000.25), make("2.pcd", "ascii", 6000.75),
                                          make("3.pcd", "binary_compressed", -7)};
  const Scan scan = Scan::open(paths);
  EXPECT_EQ(scan.paths(), paths);
  EXPECT_EQ(scan.size(), 7U);
  EXPECT_EQ(scan.origin(), Eigen::Vector3d(5000.25, 0, 0));
  const Pass pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 7U);
  EXPECT_EQ(pass.counts.invalid, 4U);
  expectPoints(pass.points, {{5000.25, 0, 0}, {6000.75, 0, 0}, {-7, 0, 0}});
}

TEST(Scan, PointsInMemory) {
  const Scan scan = Scan::fromPoints({{kNan, 0, 0}, {289814.5, 4320978.5, 0}, {289815.25, 4320978.25, kInf}});
  EXPECT_EQ(scan.origin(), Eigen::Vector3d(289814.5, 4320978.5, 0));
  EXPECT_EQ(scan.size(), 3U);
  EXPECT_TRUE(scan.paths().empty());
  const Pass pass = passOf(scan);
  EXPECT_EQ(pass.counts.points, 3U);
  EXPECT_EQ(pass.counts.invalid, 2U);
  expectPoints(pass.points, {{289814.5, 4320978.5, 0}});
  EXPECT_EQ(passOf(Scan::fromPoints({})).counts.points, 0U);
  EXPECT_EQ(passOf(Scan::fromPoints(Points(100000, Eigen::Vector3d(1, 2, 3)))).points.size(), 100000U);
}

TEST(Scan, OriginHasNoNegativeZero) { EXPECT_FALSE(std::signbit(Scan::fromPoints({{-0.0, -0.2, -0.2}}).origin().x())); }

TEST(Scan, WrongUse) {
  EXPECT_NE(errorOf([] { Scan::open({}); }, Error::Kind::Option).find("at least one file"), std::string::npos);
  for (const double unit : {0.0, -1.0, kNan, kInf}) {
    EXPECT_NE(errorOf([&] { Scan::open({"a.pcd"}, unit); }, Error::Kind::Option).find("metres_per_unit"),
              std::string::npos);
  }
}

TEST(Scan, FromRowsSeesTheHoldersPointsInEveryPass) {
  Points held = {{1, 2, 3}, {NAN, 0, 0}, {4, 6, 9}};
  const Scan scan = Scan::fromRows(held.size(), [&](std::uint64_t i) { return held[i]; });
  EXPECT_EQ(scan.size(), 3U);
  EXPECT_EQ(scan.origin(), Eigen::Vector3d(1, 2, 3));
  Points seen;
  const auto see = [&](const Points& block) { seen.insert(seen.end(), block.begin(), block.end()); };
  EXPECT_EQ(scan.forEachBlock(see).invalid, 1U);
  held[2].z() = 10;
  scan.forEachBlock(see);
  EXPECT_EQ(seen, (Points{{0, 0, 0}, {3, 4, 6}, {0, 0, 0}, {3, 4, 7}}));
}

TEST(Scan, CoordinateStepIsThatOfTheCoarsestStoredNumber) {
  const Folder folder;
  const auto step = [&](int size, const std::string& encoding) {
    const std::vector<Field> fields = {{"x", 'F', size}, {"y", 'F', size}, {"z", 'F', size}};
    return Scan::open({folder.file("a.pcd", pcd_files::pcd(fields, {{512034, 4012877, 3}}, encoding))})
        .coordinateStep();
  };
  EXPECT_EQ(step(4, "binary"), 0.25);
  EXPECT_EQ(step(4, "ascii"), 0.0);
  EXPECT_LT(step(8, "binary"), 1e-8);
  EXPECT_EQ(Scan::fromPoints({{4e6, 4e6, 0}}).coordinateStep(), 0.0);
}

TEST(Scan, CoordinateStepOfFloatsInMemoryIsThatOfAFile) {
  const auto row = [](std::uint64_t) { return Eigen::Vector3d(512034, 4012877, 3); };
  EXPECT_EQ(Scan::fromRows(1, row, {true}).coordinateStep(), 0.25);
  EXPECT_EQ(Scan::fromRows(1, row, {true, 0.001}).coordinateStep(), 0.256);  // of millimetres
  EXPECT_EQ(Scan::fromRows(1, row, {false}).coordinateStep(), 0.0);
}

}  // namespace tank_datum::scan_test
