#include "run_main.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

namespace tank_datum::run_main_test {

struct Outcome {
  int status;
  std::string said;
};

template <typename Thrown>
Outcome outcomeOf(const Thrown& thrown) {
  testing::internal::CaptureStderr();
  const int status = runMain(
      "program", [&]() -> int { throw thrown; }, [] { return std::string("; the rest stands"); });
  return {status, testing::internal::GetCapturedStderr()};
}

TEST(RunMain, GivesTheStatusOfItsWork) {
  EXPECT_EQ(runMain("program", [] { return 0; }), 0);
  EXPECT_EQ(runMain("program", [] { return 1; }), 1);
}

/// As in a library's parallel region: no handler further up is asked.
TEST(RunMain, EndsWhatNobodyCatchesCleanly) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto work = [&]() -> int {
    const results::OnStop clean([&] { std::fputs("cleaned up\n", stderr); });
    std::thread([] { throw std::bad_alloc(); }).join();
    return 0;
  };
  EXPECT_EXIT(
      runMain("program", work), testing::ExitedWithCode(3),
      "^program: memory: more than there is, expected a machine with more memory, or fewer points\ncleaned up\n$");
}

TEST(RunMain, EndsEveryExceptionAsOneLineAndAStatusOfTheContract) {
  const Outcome option = outcomeOf(Error(Error::Kind::Option, "crop", "reach", "-1", "> 0"));
  EXPECT_EQ(option.status, 2);
  EXPECT_EQ(option.said, "program: crop: reach, -1, expected > 0; the rest stands\n");
  EXPECT_EQ(outcomeOf(Error(Error::Kind::File, "io", "a.pcd", "gone", "a file")).status, 3);
  const Outcome files = outcomeOf(
      std::filesystem::filesystem_error("status", "/a/b", std::make_error_code(std::errc::permission_denied)));
  EXPECT_EQ(files.status, 3);
  EXPECT_EQ(files.said,
            "program: files: /a/b, Permission denied, expected a path that can be read and written; the rest stands\n");
  EXPECT_EQ(outcomeOf(std::bad_alloc()).status, 3);
  const Outcome threads = outcomeOf(std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)));
  EXPECT_EQ(threads.status, 3);
  EXPECT_EQ(threads.said,
            "program: system: Resource temporarily unavailable, expected a machine that grants it; the rest "
            "stands\n");
  const Outcome other = outcomeOf(std::runtime_error("two\nlines"));
  EXPECT_EQ(other.status, 3);
  EXPECT_EQ(other.said.find('\n'), other.said.size() - 1);
}

}  // namespace tank_datum::run_main_test
