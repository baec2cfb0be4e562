#include "io/pcd_writer.h"

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>

#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

std::string nameOf(PcdWriter::Format format) { return format == PcdWriter::Format::Ascii ? "ascii" : "binary"; }
void PrintTo(PcdWriter::Format format, std::ostream* out) { *out << nameOf(format); }

namespace pcd_writer_test {

using pcd_files::errorOf;
using pcd_files::Folder;
using Format = PcdWriter::Format;

const std::vector<PcdField> kXyz = {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class PcdWriterFormat : public testing::TestWithParam<Format> {};
INSTANTIATE_TEST_SUITE_P(All, PcdWriterFormat, testing::Values(Format::Ascii, Format::Binary),
                         [](const testing::TestParamInfo<Format>& of) { return nameOf(of.param); });

TEST_P(PcdWriterFormat, PclReadsWhatWasWritten) {
  const Folder folder;
  PcdWriter writer(folder.path("a.pcd"), {{"intensity", 'U', 2}, {"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}},
                   GetParam());
  writer.append({65535, 1, 2, 3, 0, 1e-7, -2.5, 0.1});
  writer.append({});
  writer.append({7, kNan, 0, 0});
  writer.commit();

  pcl::PCLPointCloud2 raw;
  ASSERT_EQ(pcl::PCDReader().read(folder.path("a.pcd"), raw), 0);
  EXPECT_EQ(raw.fields.size(), 4U);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  ASSERT_EQ(pcl::io::loadPCDFile(folder.path("a.pcd"), cloud), 0);
  ASSERT_EQ(cloud.size(), 3U);
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud[0].getVector3fMap(), Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(cloud[1].getVector3fMap(), Eigen::Vector3f(1e-7f, -2.5f, 0.1f));
  EXPECT_TRUE(std::isnan(cloud[2].x));
}

TEST_P(PcdWriterFormat, DoublesComeBackExactly) {
  const Folder folder;
  const std::vector<double> values = {289814.151234567, 4320978.612345678, 170.7612345678901};
  PcdWriter writer(folder.path("a.pcd"), {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}}, GetParam());
  writer.append(values);
  writer.commit();
  const Scan scan = Scan::open({folder.path("a.pcd")});
  scan.forEachBlock([&](const Points& block) {
    const Eigen::Vector3d point = block[0] + scan.origin();
    EXPECT_EQ(point, Eigen::Vector3d(values[0], values[1], values[2]));
  });
}

TEST_P(PcdWriterFormat, EmptyFile) {
  const Folder folder;
  PcdWriter(folder.path("a.pcd"), kXyz, GetParam()).commit();
  EXPECT_EQ(Scan::open({folder.path("a.pcd")}).size(), 0U);
}

TEST_P(PcdWriterFormat, IntegersAtTheirLimits) {
  const Folder folder;
  PcdWriter writer(folder.path("a.pcd"), {{"x", 'I', 1}, {"y", 'U', 4}, {"z", 'I', 8}}, GetParam());
  writer.append({-128, 4294967295.0, -9223372036854775808.0});
  EXPECT_NE(errorOf([&] { writer.append({128, 0, 0}); }, Error::Kind::Option).find("field x"), std::string::npos);
  EXPECT_NE(errorOf([&] { writer.append({0, -1, 0}); }, Error::Kind::Option).find("U 4"), std::string::npos);
  errorOf([&] { writer.append({0, 0, 9223372036854775808.0}); }, Error::Kind::Option);
  errorOf([&] { writer.append({kNan, 0, 0}); }, Error::Kind::Option);
  writer.commit();
  const Scan scan = Scan::open({folder.path("a.pcd")});
  EXPECT_EQ(scan.size(), 1U);
  scan.forEachBlock([&](const Points& block) {
    const Eigen::Vector3d point = block[0] + scan.origin();
    EXPECT_EQ(point, Eigen::Vector3d(-128, 4294967295.0, -9223372036854775808.0));
  });
}

TEST(PcdWriter, SameRowsGiveTheSameBytes) {
  const Folder folder;
  for (const std::string name : {"a.pcd", "b.pcd"}) {
    PcdWriter writer(folder.path(name), kXyz);
    writer.append({1, 2, 3});
    writer.commit();
  }
  EXPECT_EQ(pcd_files::readAll(folder.path("a.pcd")), pcd_files::readAll(folder.path("b.pcd")));
}

TEST(PcdWriter, NothingUnderTheNameUntilCommit) {
  const Folder folder;
  folder.file("a.pcd", "old");
  {
    PcdWriter writer(folder.path("a.pcd"), kXyz);
    writer.append({1, 2, 3});
    EXPECT_EQ(folder.entries(), 2U);
    EXPECT_EQ(pcd_files::readAll(folder.path("a.pcd")), "old");
  }
  EXPECT_EQ(folder.entries(), 1U);  // given up: the temporary file is gone
  PcdWriter first(folder.path("a.pcd"), kXyz), second(folder.path("a.pcd"), kXyz);
  first.append({1, 2, 3});
  first.commit();
  second.commit();
  EXPECT_EQ(folder.entries(), 1U);
  EXPECT_EQ(Scan::open({folder.path("a.pcd")}).size(), 0U);  // the last to commit
}

TEST(PcdWriter, RelativePathWithoutFolder) {
  const std::string name = "tank_datum_pcd_writer_test.pcd";
  PcdWriter(name, kXyz).commit();
  EXPECT_TRUE(std::filesystem::remove(name));
}

TEST(PcdWriter, FileErrorsNameThePath) {
  const Folder folder;
  EXPECT_NE(errorOf([&] { PcdWriter(folder.path("none/a.pcd"), kXyz); }).find("none/a.pcd, No such file"),
            std::string::npos);
  std::filesystem::create_directory(folder.path("b.pcd"));
  EXPECT_NE(errorOf([&] { PcdWriter(folder.path("b.pcd"), kXyz).commit(); }).find("b.pcd"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1U);
}

/// Renamed onto, a device would be gone for the whole machine.
TEST(PcdWriter, TakesThePlaceOfNoDeviceAndNoFolder) {
  const Folder folder;
  for (const std::string& path : {std::string("/dev/null"), folder.path("")}) {
    const std::string error = errorOf([&] { PcdWriter(path, {{"x", 'F', 4}}, PcdWriter::Format::Binary); });
    EXPECT_NE(error.find(path), std::string::npos) << error;
    EXPECT_NE(error.find("the name of a new one"), std::string::npos) << error;
  }
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
}

TEST(PcdWriter, FullDiskIsAnError) {
  const Folder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string many = errorOf([&] {
    PcdWriter writer(folder.path("a.pcd"), kXyz);
    for (int i = 0; i < 10; ++i) writer.append(std::vector<double>(3000, 1.0));
  });
  const std::string few = errorOf([&] {  // stays in the stream's buffer until commit
    PcdWriter writer(folder.path("a.pcd"), kXyz);
    writer.append(std::vector<double>(1200, 1.0));
    writer.commit();
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_NE(many.find("File too large"), std::string::npos) << many;
  EXPECT_NE(few.find("a.pcd"), std::string::npos) << few;
  EXPECT_EQ(folder.entries(), 0U);
}

TEST(PcdWriter, WrongUse) {
  const Folder folder;
  const auto refused = [&](const std::vector<PcdField>& fields) {
    return errorOf([&] { PcdWriter(folder.path("a.pcd"), fields); }, Error::Kind::Option);
  };
  EXPECT_NE(refused({}).find("at least one"), std::string::npos);
  EXPECT_NE(refused({{"x y", 'F', 4}}).find("\"x y\""), std::string::npos);
  EXPECT_NE(refused({{"x", 'F', 2}}).find("field x, F 2"), std::string::npos);
  EXPECT_NE(refused({{"x", 'I', 3}}).find("I 3"), std::string::npos);

  PcdWriter writer(folder.path("a.pcd"), kXyz);
  errorOf([&] { writer.append({1, 2}); }, Error::Kind::Option);
  writer.commit();
  errorOf([&] { writer.append({1, 2, 3}); }, Error::Kind::Option);
  errorOf([&] { writer.commit(); }, Error::Kind::Option);
}

}  // namespace pcd_writer_test
}  // namespace tank_datum
