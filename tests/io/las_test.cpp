#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "io/block.h"
#include "support/las_files.h"
#include "support/read_scans.h"

/// LAS files: scale and offset, classes, setups, and headers that lie.
namespace tank_datum::las_test {

using las_files::Las;
using read_scans::passOf;
using read_scans::refusalOf;

Las threePoints() {
  Las las;
  las.scale = {0.01, 0.001, 0.0005};
  las.shift = {500000.0, 4000000.0, -10.0};
  las.points = {{{1, 2, 3}}, {{-100, 2000, 30000}}, {{2147483647, -2147483647 - 1, 0}}};
  return las;
}

const Points kThree = {
    {500000.01, 4000000.002, -9.9985}, {499999.0, 4000002.0, 5.0}, {21974836.47, 1852516.352, -10.0}};

std::string withNumber(std::string bytes, std::size_t offset, double value) {
  las_files::put(bytes, offset, value);
  return bytes;
}

template <typename T>
std::string with(std::size_t offset, T value) {
  std::string bytes = las_files::las(threePoints());
  las_files::put(bytes, offset, value);
  return bytes;
}

TEST(Las, EveryVersionAndPointFormat) {
  const pcd_files::Folder folder;
  for (unsigned minor = 0; minor <= 4; ++minor) {
    for (unsigned format = 0; format <= 10; ++format) {
      Las las = threePoints();
      las.minor = minor;
      las.format = format;
      las.extra_bytes = format % 3;
      las.gap = 54 * minor;
      const auto pass = passOf(Scan::open({folder.file("a.las", las_files::las(las))}));
      read_scans::expectNear(pass.points, kThree, 1e-8);
      EXPECT_EQ(pass.counts.points, 3U);
      EXPECT_EQ(pass.counts.kept(), 3U);
    }
  }
}

TEST(Las, TheNameDoesNotCount) {
  const pcd_files::Folder folder;
  EXPECT_EQ(Scan::open({folder.file("scan.pcd", las_files::las(threePoints()))}).size(), 3U);
}

TEST(Las, UnitsScaleWhatIsMeantAndTheStep) {
  const pcd_files::Folder folder;
  Las las;
  las.scale = {0.5, 2.0, 1.0};
  las.shift = {1000.0, 0.0, 0.0};
  las.points = {{{2, 3, 4}}};
  const Scan scan = Scan::open({folder.file("a.las", las_files::las(las))}, 0.001);
  read_scans::expectNear(passOf(scan).points, {{1.001, 0.006, 0.004}}, 1e-12);
  EXPECT_DOUBLE_EQ(scan.coordinateStep(), 0.002);  // the longest of the axes
}

TEST(Las, TheCountOf64BitsIsThatOfVersion14) {
  const pcd_files::Folder folder;
  Las las = threePoints();
  las.minor = 4;
  std::string bytes = las_files::las(las);
  EXPECT_EQ(Scan::open({folder.file("a.las", bytes)}).size(), 3U);
  las_files::put<std::uint32_t>(bytes, 107, 2);  // of 32 bits: not asked
  EXPECT_EQ(Scan::open({folder.file("b.las", bytes)}).size(), 3U);
  las_files::put<std::uint64_t>(bytes, 247, 0);  // the only one
  EXPECT_EQ(Scan::open({folder.file("c.las", bytes)}).size(), 2U);
}

TEST(Las, BytesBehindThePointsArePassedOver) {
  const pcd_files::Folder folder;
  const std::string bytes = las_files::las(threePoints()) + std::string(1000, 'x');
  EXPECT_EQ(passOf(Scan::open({folder.file("a.las", bytes)})).counts.points, 3U);
}

/// 40 000 points of classes 2, 6 and 129 or 1, every tenth withheld, in setups 0, 7 and 9 after one another.
Las manyPoints(unsigned format) {
  Las las;
  las.format = format;
  las.minor = format < 6 ? 2 : 4;
  for (int i = 0; i < 40'000; ++i) {
    const unsigned code = i % 3 == 0 ? 2 : i % 3 == 1 ? 6 : format < 6 ? 1 : 129;
    las.points.push_back({{i, 2 * i, 1000}, code, i % 10 == 0, i < 10'000 ? 0U : i < 20'000 ? 7U : 9U});
  }
  return las;
}

std::uint64_t pointsOf(const std::string& path, const std::vector<int>& classes, std::uint64_t n = 1) {
  ScanOptions options;
  options.las_classes = classes;
  const auto pass = passOf(Scan::open({path}, 1.0, options), 2, n);
  EXPECT_EQ(pass.counts.points, 40'000U);
  EXPECT_EQ(pass.counts.invalid, 0U);
  if (n == 1) {
    EXPECT_EQ(pass.counts.kept(), pass.points.size());
  }
  return pass.counts.kept();
}

TEST(Las, ClassesAreChosenAndWithheldPointsLeftOut) {
  const pcd_files::Folder folder;
  for (const unsigned format : {0U, 5U, 6U, 10U}) {
    const std::string path = folder.file("a.las", las_files::las(manyPoints(format)));
    EXPECT_EQ(pointsOf(path, {}), 36'000U);
    EXPECT_EQ(pointsOf(path, {2}), 12'000U);
    EXPECT_EQ(pointsOf(path, {2, 6}), 24'000U);
    EXPECT_EQ(pointsOf(path, {129}), format < 6 ? 0U : 12'000U);
    EXPECT_EQ(pointsOf(path, {2}, 7), 12'000U);  // of all rows, however few are decoded
  }
  const std::string path = folder.file("a.las", las_files::las(manyPoints(6)));
  for (const int code : {-1, 256}) {
    ScanOptions options;
    options.las_classes = {code};
    const std::string message = pcd_files::errorOf([&] { Scan::open({path}, 1.0, options); }, Error::Kind::Option);
    EXPECT_NE(message.find("las_classes, " + std::to_string(code)), std::string::npos) << message;
  }
}

TEST(Las, ClassesOfOtherFormatsAreRefused) {
  const pcd_files::Folder folder;
  ScanOptions options;
  options.las_classes = {2};
  const std::string path = folder.file("a.xyz", "1 2 3\n4 5 6\n7 8 9\n");
  const std::string message = pcd_files::errorOf([&] { Scan::open({path}, 1.0, options); }, Error::Kind::Option);
  EXPECT_NE(message.find("las_classes, given for " + path + ", expected LAS files"), std::string::npos) << message;
}

TEST(Las, EveryNthRowIsCountedBeforeClassesAre) {
  const pcd_files::Folder folder;
  ScanOptions options;
  options.las_classes = {6};
  const Scan scan = Scan::open({folder.file("a.las", las_files::las(manyPoints(6)))}, 1.0, options);
  for (const auto& p : passOf(scan, 2, 5).points) {
    const auto row = static_cast<std::uint64_t>(std::lround(p.x() / 0.001));
    ASSERT_EQ(row % 3, 1U);
    ASSERT_NE(row % 10, 0U);
    ASSERT_EQ(row % kBlockRows % 5, row / kBlockRows) << row;
  }
}

TEST(Las, PointSourcesAreSetups) {
  const pcd_files::Folder folder;
  for (const unsigned format : {1U, 7U}) {
    const Scan scan = Scan::open({folder.file("hall.las", las_files::las(manyPoints(format)))});
    const auto pass = passOf(scan);
    ASSERT_EQ(pass.setups.size(), 3U);
    EXPECT_EQ(pass.setups.at(0).size(), 9'000U);
    EXPECT_EQ(pass.setups.at(7).size(), 9'000U);
    EXPECT_EQ(pass.setups.at(9).size(), 18'000U);
    EXPECT_TRUE(scan.tellsSetups());
    EXPECT_EQ(scan.setupName({0, 0}), "hall");  // source 0: the file itself
    EXPECT_EQ(scan.setupName({0, 7}), "7");
    EXPECT_FALSE(scan.setupOrigin({0, 7}));
  }
}

TEST(Las, HeadersThatLie) {
  const auto expect = [](const std::string& bytes, const std::string& part) {
    const std::string message = refusalOf(bytes);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  const std::string good = las_files::las(threePoints());
  expect(good.substr(0, 226), "LAS header of ");
  expect(with<std::uint8_t>(24, 2), "LAS version of ");
  expect(with<std::uint8_t>(25, 5), "1.5, expected 1.0 to 1.4");
  expect(with<std::uint8_t>(25, 4), "LAS header of ");  // cut before its end
  expect(with<std::uint16_t>(94, 226), "226 bytes, expected at least 227");
  expect(with<std::uint32_t>(96, 226), "LAS offset to the points of ");
  expect(with<std::uint32_t>(96, 4'000'000'000U), "4000000000, expected at least 227 and at most 287");
  expect(with<std::uint8_t>(104, 11), "LAS point format of ");
  expect(with<std::uint8_t>(104, 0x80), "LAZ, expected PCD, LAS, PLY");
  expect(with<std::uint8_t>(104, 1), "20 bytes, expected at least 28 of point format 1");
  expect(with<std::uint16_t>(105, 0), "0 bytes, expected at least 20 of point format 0");
  expect(with<std::uint32_t>(107, 4), "4 in the header, expected at most 3, all that 287 bytes hold");
  expect(with<std::uint32_t>(107, 0xffffffffU), "4294967295 in the header, expected at most 3");
  expect(good.substr(0, good.size() - 1), "3 in the header, expected at most 2");
  for (const double bad : {0.0, -0.001, std::nan(""), HUGE_VAL, 1e300}) {
    expect(withNumber(good, 131, bad), "LAS scale of x of ");
    expect(withNumber(good, 147, bad), "LAS scale of z of ");
  }
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    expect(withNumber(good, 155, bad), "LAS offset of x of ");
    expect(withNumber(good, 171, bad), "LAS offset of z of ");
  }
  Las las = threePoints();
  las.minor = 4;
  std::string bytes = las_files::las(las);
  las_files::put<std::uint64_t>(bytes, 247, std::uint64_t{1} << 40);
  expect(bytes, "1099511627776 in the header, expected at most 3");
}

TEST(Las, CutAnywhereOrWithAnyByteChanged) {
  Las las = threePoints();
  las.minor = 4;
  const std::string good = las_files::las(las);
  for (std::size_t length = 0; length < good.size(); ++length) {
    EXPECT_FALSE(refusalOf(good.substr(0, length)).empty()) << length;
  }
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char byte : {'\x7f', '\xff'}) {
      std::string bytes = good;
      bytes[at] = byte;
      read_scans::readHostile(bytes);
    }
  }
}

}  // namespace tank_datum::las_test
