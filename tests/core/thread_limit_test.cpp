#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>

#include "core/parallel.h"

namespace tank_datum::thread_limit_test {

TEST(ForEachIndex, GoesOnWithoutTheThreadsThatCannotBeHad) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const auto work = [] {
    const struct rlimit none { 1, 1 };
    ::setrlimit(RLIMIT_AS, &none);  // no stack for any thread
    int done[1000] = {};
    forEachIndex(1000, 100, [&](std::size_t i) { ++done[i]; });
    std::_Exit(std::all_of(done, done + 1000, [](int times) { return times == 1; }) ? 0 : 1);
  };
  EXPECT_EXIT(work(), testing::ExitedWithCode(0), "");
}

}  // namespace tank_datum::thread_limit_test
