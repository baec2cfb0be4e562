#include "run_main.h"

#include <unistd.h>

#include <Eigen/Core>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#include "core/printable.h"
#include "exit_status.h"
#include "flag_names.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr const char* kNoMemory = "memory: more than there is, expected a machine with more memory, or fewer points";

std::string& nameOfProgram() {
  static std::string name;
  return name;
}

/// Of what ends the process, without asking for memory.
const char* reasonToEnd() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::bad_alloc&) {
    return kNoMemory;
  } catch (...) {
    return "unexpected: an exception in a thread, expected no such failure: please report it";
  }
  return "unexpected: a library ended the run, as without memory, expected a machine with more of it, or fewer points";
}

/// Instead of an abort: a library's parallel region, from which no exception comes out, may be where memory ends.
[[noreturn]] void endAtOnce() {
  static std::atomic<bool> begun{false};
  if (!begun.exchange(true)) {
    const char* parts[] = {nameOfProgram().c_str(), ": ", reasonToEnd(), "\n"};
    for (const char* part : parts) {
      if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;  // nobody is left to be told
    }
    results::cleanUpForGood();
  }
  std::_Exit(kFileFailed);
}

}  // namespace

int runMain(const std::string& program, const std::function<int()>& work,
            const std::function<std::string()>& after_failure) {
  const auto failed = [&](const std::string& reason, int status) {
    std::cerr << program << ": " << printable(reason) << printable(after_failure ? after_failure() : "") << "\n";
    return status;
  };
  try {
    nameOfProgram() = program;
    std::set_terminate(endAtOnce);
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond what is allowed is a write that fails, as on a full disk
    Eigen::setNbThreads(1);  // OpenMP, by which Eigen has large products done, ends the process for want of a thread
    results::stopCleanly(program);
    return work();
  } catch (const Error& error) {
    return failed(lineOf(error), error.kind() == Error::Kind::Option ? kWrongUse : kFileFailed);
  } catch (const std::bad_alloc&) {
    return failed(kNoMemory, kFileFailed);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed("files: " + error.path1().string() + ", " + error.code().message() +
                      ", expected a path that can be read and written",
                  kFileFailed);
  } catch (const std::system_error& error) {
    return failed(std::string("system: ") + error.what() + ", expected a machine that grants it", kFileFailed);
  } catch (const std::exception& error) {
    return failed(std::string("unexpected: ") + error.what() + ", expected no such failure: please report it",
                  kFileFailed);
  }
}

}  // namespace tank_datum
