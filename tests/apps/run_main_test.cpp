#include "run_main.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>

#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

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
  const Outcome other = outcomeOf(std::runtime_error("two\nlines"));
  EXPECT_EQ(other.status, 3);
  EXPECT_EQ(other.said.find('\n'), other.said.size() - 1);
}

}  // namespace
}  // namespace tank_datum
