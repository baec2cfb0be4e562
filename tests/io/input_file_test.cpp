#include "io/input_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>

#include "io/pcd_writer.h"
#include "io/whole_file.h"
#include "support/refused.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::input_file_test {

using Change = std::function<void(const std::string& path)>;

/// When the file was last written to; clocks of file systems tick every few milliseconds.
void setTime(const std::string& path, long nanoseconds) {
  const struct timespec times[2] = {{1'700'000'000, nanoseconds}, {1'700'000'000, nanoseconds}};
  ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
}

/// Writes over the first bytes of what is there.
void writeOver(const std::string& path, const std::string& bytes) {
  std::fstream(path, std::ios::in | std::ios::out | std::ios::binary) << bytes;
}

const std::map<std::string, Change>& changes() {
  static const std::map<std::string, Change> all = {
      {"grown", [](const std::string& path) { std::ofstream(path, std::ios::app) << "x"; }},
      {"truncated", [](const std::string& path) { std::filesystem::resize_file(path, 1); }},
      {"rewritten at the same size",
       [](const std::string& path) {
         writeOver(path, "#");
         setTime(path, 1);
       }},
      {"replaced",
       [](const std::string& path) {
         std::filesystem::copy_file(path, path + ".other");
         setTime(path + ".other", 0);
         std::filesystem::rename(path + ".other", path);
       }},
      {"removed", [](const std::string& path) { std::filesystem::remove(path); }},
  };
  return all;
}

TEST(InputFile, TellsThatItChanged) {
  for (const auto& [name, change] : changes()) {
    const TestFolder folder;
    const std::string path = folder.file("a.txt", "one");
    setTime(path, 0);
    const InputFile file(path);
    EXPECT_EQ(refusalOf(Error::Kind::File, [&] { file.requireUnchanged(); }), "") << name;
    change(path);
    EXPECT_EQ(refusalOf(Error::Kind::File, [&] { file.requireUnchanged(); }),
              "io: reading of " + path + ", changed meanwhile, expected a file that nobody writes, moves or removes " +
                  "during the run")
        << name;
  }
}

TEST(InputFile, TellsThatItChangedWithinATickOfTheFileSystemsClock) {
  const TestFolder folder;
  const std::string path = folder.file("a", "");
  for (int i = 0; i < 20; ++i) {
    std::ofstream(path) << "old";
    const InputFile file(path);
    writeOver(path, "new");
    EXPECT_NE(refusalOf(Error::Kind::File, [&] { file.requireUnchanged(); }), "");
  }
}

TEST(InputFile, WaitsForATickAfterAWriteAndNoLonger) {
  const TestFolder folder;
  const std::string path = folder.file("a", "");
  using Clock = std::chrono::system_clock;
  auto fastest = std::chrono::nanoseconds::max();
  for (int i = 0; i < 20; ++i) {
    const Clock::time_point begun = Clock::now();
    const auto written = begun.time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(written);
    std::ofstream(path) << "x";
    const struct timespec time { seconds.count(), std::chrono::nanoseconds(written - seconds).count() };
    const struct timespec times[2] = {time, time};
    ASSERT_EQ(::utimensat(AT_FDCWD, path.c_str(), times, 0), 0);
    const InputFile file(path);
    fastest = std::min<std::chrono::nanoseconds>(fastest, Clock::now() - begun);
  }
  EXPECT_GE(fastest, std::chrono::milliseconds(10));
  EXPECT_LT(fastest, std::chrono::milliseconds(18));
}

TEST(InputFile, RefusesAPipeWithoutWaiting) {
  const TestFolder folder;
  const std::string path = folder.path("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { const InputFile file(path); }),
            "io: opening of " + path + ", not a regular file, expected a file that can be read");
}

std::string writtenScan(const TestFolder& folder, int rows) {
  const std::string path = folder.path("a.pcd");
  PcdWriter writer(path, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}, PcdWriter::Format::Binary);
  std::vector<double> values;
  for (int i = 0; i < rows; ++i) values.insert(values.end(), {1.0 + i, 2.0, 3.0});
  writer.append(values);
  writer.commit();
  setTime(path, 0);
  return path;
}

/// Whatever a pass meets in a file that changes during it, or changed since the pass before, that is what it says.
TEST(Scan, PassesSayThatTheFileChanged) {
  constexpr int kRows = 100'000;
  for (const auto& [name, change] : changes()) {
    for (const bool chosen : {false, true}) {
      const TestFolder folder;
      const std::string path = writtenScan(folder, kRows);
      const Scan scan = Scan::open({path});
      bool done = false;
      const auto pass = [&, &change = change](const Points&) {
        if (!done) change(path);
        done = true;
      };
      const auto all = [](std::uint64_t, const Points& points, Points& wanted) { wanted = points; };
      const auto run = [&] { chosen ? scan.forEachChosen(all, 2, pass) : scan.forEachBlock(pass); };
      EXPECT_NE(refusalOf(Error::Kind::File, run).find("changed meanwhile"), std::string::npos) << name << chosen;
      EXPECT_NE(refusalOf(Error::Kind::File, run).find("changed meanwhile"), std::string::npos)
          << name << chosen << " again";
      EXPECT_NE(refusalOf(Error::Kind::File, [&] { scan.requireUnchanged(); }), "") << name;
    }
  }
}

TEST(WholeFile, IsReadAsItIs) {
  const TestFolder folder;
  EXPECT_EQ(wholeFile(folder.file("a", std::string("one\0two", 7)), "limits"), std::string("one\0two", 7));
  EXPECT_EQ(wholeFile(folder.file("b", ""), "limits"), "");
}

TEST(WholeFile, NamesAFileThatCannotBeRead) {
  const TestFolder folder;
  EXPECT_EQ(refusalOf(Error::Kind::File, [] { wholeFile("/none/there.csv", "limits"); }),
            "limits: opening of /none/there.csv, No such file or directory, expected a file that can be read");
  EXPECT_EQ(refusalOf(Error::Kind::File, [] { wholeFile("/tmp", "limits"); }),
            "limits: opening of /tmp, a folder, expected a file that can be read");
  EXPECT_EQ(refusalOf(Error::Kind::File, [] { wholeFile("/dev/zero", "limits"); }),
            "limits: opening of /dev/zero, not a regular file, expected a file that can be read");
  const std::string path = folder.file("c", "12345");
  EXPECT_EQ(wholeFile(path, "about", 5), "12345");
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { wholeFile(path, "about", 4); }),
            "about: size of " + path + ", 5 bytes, expected a file of at most 4 bytes");
}

TEST(WholeFile, IsNoLargerThanAnyTable) {
  const TestFolder folder;
  const std::string path = folder.file("sparse", "");
  std::filesystem::resize_file(path, (std::uint64_t{1} << 28) + 1);
  EXPECT_NE(refusalOf(Error::Kind::File, [&] { wholeFile(path, "limits"); }).find("at most 256 MB"), std::string::npos);
}

}  // namespace tank_datum::input_file_test
