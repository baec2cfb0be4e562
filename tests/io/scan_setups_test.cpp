#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "io/pcd_writer.h"
#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

/// Which setup of the scanner a point comes from.
namespace tank_datum::scan_setups_test {

using Found = std::map<std::pair<std::uint32_t, std::uint32_t>, Points>;

constexpr std::size_t kRows = 40'000;

double labelOfRow(std::size_t i) { return i < kRows / 2 ? 3.0 : i % 2 == 0 ? 7.0 : 65535.0; }

/// Points whose x is their row; every thousandth is not finite.
std::string written(const pcd_files::Folder& folder, const std::string& name, const std::string& label, char type,
                    PcdWriter::Format format, const std::array<double, 3>& viewpoint = {}) {
  std::vector<PcdField> fields = {{"x", 'F', 4}, {"y", 'F', 4}};
  if (!label.empty()) fields.push_back({label, type, type == 'F' ? 4 : 2});
  fields.push_back({"z", 'F', 4});
  PcdWriter writer(folder.path(name), fields, format, {"", viewpoint});
  std::vector<double> rows;
  for (std::size_t i = 0; i < kRows; ++i) {
    rows.push_back(i % 1000 == 999 ? std::nan("") : static_cast<double>(i));
    rows.push_back(1.0);
    if (!label.empty()) rows.push_back(labelOfRow(i));
    rows.push_back(2.0);
  }
  writer.append(rows);
  writer.commit();
  return folder.path(name);
}

Found setupsOf(const Scan& scan, std::uint64_t n = 1, int threads = 2) {
  Found found;
  const auto all = [](std::uint64_t, const Points& points, Points& chosen) { chosen = points; };
  scan.forEachChosen(
      all, threads,
      [&](const Points& chosen, SetupKey setup) {
        Points& own = found[{setup.source, setup.label}];
        own.insert(own.end(), chosen.begin(), chosen.end());
      },
      n);
  return found;
}

void expectLabels(const Scan& scan, std::uint64_t n) {
  const Found found = setupsOf(scan, n);
  ASSERT_EQ(found.size(), 3U);
  std::size_t count = 0;
  for (const auto& [key, points] : found) {
    EXPECT_EQ(key.first, 0U);
    for (const auto& p : points) {
      const auto row = static_cast<std::size_t>(std::lround(p.x() + scan.origin().x()));
      ASSERT_EQ(labelOfRow(row), static_cast<double>(key.second)) << row;
    }
    count += points.size();
  }
  EXPECT_NEAR(static_cast<double>(count), 0.999 * kRows / static_cast<double>(n), 3.0);
}

TEST(ScanSetups, LabelsGoWithTheirPointsInEveryEncoding) {
  const pcd_files::Folder folder;
  for (const auto format : {PcdWriter::Format::Binary, PcdWriter::Format::Ascii}) {
    for (const char* field : {"setup", "scan_id", "point_source_id"}) {
      const Scan scan = Scan::open({written(folder, "a.pcd", field, 'U', format)});
      EXPECT_TRUE(scan.tellsSetups());
      for (const std::uint64_t n : {std::uint64_t{1}, std::uint64_t{7}}) expectLabels(scan, n);
      EXPECT_EQ(scan.setupName({0, 7}), "7");
    }
  }
  expectLabels(Scan::open({written(folder, "f.pcd", "setup", 'F', PcdWriter::Format::Binary)}), 1);
}

TEST(ScanSetups, TheCountsAreThoseOfAScanWithoutLabels) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({written(folder, "a.pcd", "setup", 'U', PcdWriter::Format::Binary)});
  const auto none = [](std::uint64_t, const Points&, Points&) {};
  const ScanCounts counts = scan.forEachChosen(none, 2, [](const Points&) {});
  EXPECT_EQ(counts.points, kRows);
  EXPECT_EQ(counts.invalid, kRows / 1000);
}

TEST(ScanSetups, FilesAreSetupsWithTheirNamesAndViewpoints) {
  const pcd_files::Folder folder;
  const std::string east = written(folder, "east.pcd", "", 'U', PcdWriter::Format::Binary, {10.0, 20.0, 1.5});
  const std::string west = written(folder, "west.pcd", "", 'U', PcdWriter::Format::Binary);
  const Scan scan = Scan::open({east, west});
  EXPECT_TRUE(scan.tellsSetups());
  EXPECT_FALSE(Scan::open({east}).tellsSetups());
  const Found found = setupsOf(scan);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.begin()->second.size(), kRows - kRows / 1000);
  EXPECT_EQ(scan.setupName({0, 0}), "east");
  EXPECT_EQ(scan.setupName({1, 0}), "west");
  ASSERT_TRUE(scan.setupOrigin({0, 0}));
  EXPECT_EQ(*scan.setupOrigin({0, 0}) + scan.origin(), Eigen::Vector3d(10.0, 20.0, 1.5));
  EXPECT_FALSE(scan.setupOrigin({1, 0}));  // zeros: not known
  const Scan millimetres = Scan::open({east, west}, 0.001);
  EXPECT_NEAR((*millimetres.setupOrigin({0, 0}) + millimetres.origin()).y(), 0.020, 1e-12);
}

TEST(ScanSetups, FilesWithLabelsAreNamedByBoth) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({written(folder, "a.pcd", "setup", 'U', PcdWriter::Format::Binary, {1.0, 2.0, 3.0}),
                                written(folder, "b.pcd", "", 'U', PcdWriter::Format::Binary)});
  EXPECT_EQ(setupsOf(scan).size(), 4U);
  EXPECT_EQ(scan.setupName({0, 3}), "a:3");
  EXPECT_EQ(scan.setupName({0, SetupKey::kUnlabelled}), "a:none");
  EXPECT_EQ(scan.setupName({1, 0}), "b");
  EXPECT_FALSE(scan.setupOrigin({0, 3}));  // one viewpoint cannot be that of several setups
}

}  // namespace tank_datum::scan_setups_test
