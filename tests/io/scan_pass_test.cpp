#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <thread>

#include "io/pcd_writer.h"
#include "support/pcd_files.h"
#include "tank_datum/io/scan.h"

/// Scan::forEachChosen, the pass in several threads; forEachBlock is the oracle.
namespace tank_datum::scan_pass_test {

constexpr std::size_t kRows = 1'200'000;  // more than one round of blocks

/// x counts the rows; every 1000th is not finite. The first lies above the frame's zero: it is the origin.
std::string writtenScan(const pcd_files::Folder& folder, std::size_t rows, PcdWriter::Format format) {
  const std::string path = folder.path("rows.pcd");
  PcdWriter writer(path, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}, format);
  std::vector<double> values;
  for (std::size_t i = 0; i < rows; ++i) {
    const double x = i % 1000 == 999 ? NAN : static_cast<double>(i);
    values.insert(values.end(), {x, static_cast<double>(i % 7), 1.0});
  }
  writer.append(values);
  writer.commit();
  return path;
}

void everyThird(std::uint64_t, const Points& points, Points& chosen) {
  for (const auto& p : points) {
    if (static_cast<std::uint64_t>(p.x()) % 3 == 0) chosen.push_back(p);
  }
}

struct Pass {
  ScanCounts counts;
  Points points;
};

Pass passOf(const Scan& scan, const Scan::Chooser& choose, int threads) {
  Pass pass;
  pass.counts = scan.forEachChosen(choose, threads, [&](const Points& chosen) {
    EXPECT_FALSE(chosen.empty());
    pass.points.insert(pass.points.end(), chosen.begin(), chosen.end());
  });
  return pass;
}

void expectEveryThird(const Scan& scan, int threads) {
  Points expected;
  const ScanCounts counts = scan.forEachBlock([&](const Points& block) { everyThird(0, block, expected); });
  const Pass pass = passOf(scan, everyThird, threads);
  EXPECT_EQ(pass.points, expected) << threads;
  EXPECT_EQ(pass.counts.points, counts.points);
  EXPECT_EQ(pass.counts.invalid, counts.invalid);
}

TEST(ScanForEachChosen, VisitsInFileOrderWhateverTheNumberOfThreads) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({writtenScan(folder, kRows, PcdWriter::Format::Binary)});
  for (const int threads : {1, 2, 5, 0}) expectEveryThird(scan, threads);
  EXPECT_EQ(passOf(scan, everyThird, 0).counts.invalid, kRows / 1000);
}

TEST(ScanForEachChosen, VisitsInTheThreadOfTheCallerAndEndsWithWhatThatThrows) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({writtenScan(folder, 3 * kRows, PcdWriter::Format::Binary)});
  std::set<std::thread::id> threads;
  std::size_t visits = 0, last = 0;
  scan.forEachChosen(everyThird, 4, [&](const Points&) {
    threads.insert(std::this_thread::get_id());
    last = ++visits;
  });
  EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
  ASSERT_GT(last, 200U);
  for (const std::size_t at : {std::size_t{1}, std::size_t{100}, last}) {
    visits = 0;
    const auto visit = [&](const Points&) {
      if (++visits == at) throw std::runtime_error("enough");
    };
    EXPECT_THROW(scan.forEachChosen(everyThird, 4, visit), std::runtime_error);
    EXPECT_EQ(visits, at);
  }
}

TEST(ScanForEachChosen, OfSeveralFilesOfAsciiAndOfPointsInMemoryToo) {
  const pcd_files::Folder folder, other;
  const std::string binary = writtenScan(folder, 50'000, PcdWriter::Format::Binary);
  const std::string ascii = writtenScan(other, 20'000, PcdWriter::Format::Ascii);
  expectEveryThird(Scan::open({ascii, binary, ascii}), 2);
  Points points;
  for (int i = 0; i < 40'000; ++i) points.emplace_back(i % 100 == 9 ? NAN : static_cast<double>(i), 0, 1);
  expectEveryThird(Scan::fromPoints(points), 2);
}

TEST(ScanForEachChosen, NumbersTheBlocksThroughAllFiles) {
  const pcd_files::Folder folder;
  const std::string path = writtenScan(folder, 50'000, PcdWriter::Format::Binary);
  const auto number = [](std::uint64_t block, const Points& points, Points& chosen) {
    chosen.emplace_back(static_cast<double>(block), static_cast<double>(points.size()), 0.0);
  };
  const Pass pass = passOf(Scan::open({path, path}), number, 0);
  ASSERT_EQ(pass.points.size(), 8U);  // of 16384 rows at most
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(pass.points[i].x(), static_cast<double>(i));
}

TEST(ScanForEachChosen, TellsHowManyRowsAreRead) {
  const pcd_files::Folder folder;
  Scan scan = Scan::open({writtenScan(folder, 50'000, PcdWriter::Format::Binary)});
  std::vector<std::uint64_t> told;
  scan.setProgress([&](std::uint64_t rows) { told.push_back(rows); });
  passOf(scan, everyThird, 2);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LT(told.front(), 50'000U);
  EXPECT_EQ(told.back(), 50'000U);
}

/// Rows of which every 1000th is not finite; x is their number.
TEST(ScanForEachChosen, OfEveryNthRowIsThatOfAllOfThem) {
  const pcd_files::Folder folder;
  const Scan file = Scan::open({writtenScan(folder, 50'000, PcdWriter::Format::Binary)});
  const auto row = [](std::uint64_t i) {
    const double x = i % 1000 == 999 ? NAN : static_cast<double>(i);
    return Eigen::Vector3d(x, static_cast<double>(i % 7), 1.0);
  };
  const auto all = [](std::uint64_t, const Points& points, Points& chosen) { chosen = points; };
  for (const std::uint64_t n : {1U, 3U, 101U, 20'001U}) {
    Points expected;
    for (std::uint64_t i = 0; i < 50'000; ++i) {
      const std::uint64_t block = i / 16384, place = i % 16384;
      if (place % n == block % n && i % 1000 != 999) expected.push_back(row(i) - row(0));
    }
    for (const Scan& scan : {file, Scan::fromRows(50'000, row)}) {
      Points chosen;
      const ScanCounts counts = scan.forEachChosen(
          all, 2, [&](const Points& some) { chosen.insert(chosen.end(), some.begin(), some.end()); }, n);
      EXPECT_EQ(chosen, expected) << n;
      EXPECT_EQ(counts.points, 50'000U);
      EXPECT_EQ(counts.invalid, 50U) << n;
      EXPECT_EQ(scan.everyNth(n, 1), expected) << n;
    }
  }
}

TEST(ScanForEachChosen, OfAsciiThinsWhatItReads) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({writtenScan(folder, 20'000, PcdWriter::Format::Ascii)});
  const Points chosen = scan.everyNth(7);
  EXPECT_NEAR(static_cast<double>(chosen.size()), 20'000 * 0.999 / 7, 2.0);
  for (std::size_t i = 1; i < chosen.size(); ++i) EXPECT_GT(chosen[i].x(), chosen[i - 1].x());
}

TEST(ScanForEachChosen, PassesOnWhatIsThrown) {
  const pcd_files::Folder folder;
  const Scan scan = Scan::open({writtenScan(folder, 50'000, PcdWriter::Format::Binary)});
  const auto fail = [](std::uint64_t, const Points&, Points&) { throw std::logic_error("enough"); };
  EXPECT_THROW(passOf(scan, fail, 2), std::logic_error);
  EXPECT_THROW(scan.forEachChosen(everyThird, 2, [](const Points&) { throw std::logic_error("enough"); }),
               std::logic_error);
}

}  // namespace tank_datum::scan_pass_test
