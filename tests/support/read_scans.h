#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/pcd_files.h"
#include "tank_datum/core/error.h"
#include "tank_datum/io/scan.h"

/// What a pass over a scan gives, for tests of file formats.
namespace tank_datum::read_scans {

struct Pass {
  ScanCounts counts;
  std::map<std::uint32_t, Points> setups;  ///< in the scan's own frame [m]
  Points points;                           ///< the same in order
};

inline Pass passOf(const Scan& scan, int threads = 2, std::uint64_t n = 1) {
  Pass pass;
  const auto all = [](std::uint64_t, const Points& points, Points& chosen) { chosen = points; };
  const auto keep = [&](const Points& chosen, SetupKey setup) {
    for (const auto& p : chosen) {
      pass.setups[setup.label].push_back(p + scan.origin());
      pass.points.push_back(p + scan.origin());
    }
  };
  pass.counts = scan.forEachChosen(all, threads, keep, n);
  return pass;
}

inline void expectNear(const Points& found, const Points& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE((found[i] - expected[i]).cwiseAbs().maxCoeff(), tolerance) << i << ": " << found[i].transpose();
  }
}

/// The message, which has one line, of an Error (File) about a file of these bytes.
inline std::string refusalOf(const std::string& bytes) {
  const pcd_files::Folder folder;
  const std::string path = folder.file("scan", bytes);
  const std::string message = pcd_files::errorOf([&] { passOf(Scan::open({path})); });
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_NE(message.find(path), std::string::npos) << message;
  return message;
}

/// Reads hostile bytes: points or an Error (File); anything else, a crash or a hang fails the test.
inline void readHostile(const std::string& bytes) {
  const pcd_files::Folder folder;
  const std::string path = folder.file("scan", bytes);
  try {
    const Pass pass = passOf(Scan::open({path}));
    EXPECT_EQ(pass.counts.kept(), pass.points.size());
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::File);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

}  // namespace tank_datum::read_scans
