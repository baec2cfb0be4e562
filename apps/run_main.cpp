#include "run_main.h"

#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
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

const char* name_of_program = "";

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
  static std::atomic<pthread_t> ending{0};
  pthread_t nobody = 0;
  if (ending.compare_exchange_strong(nobody, pthread_self())) {
    const char* parts[] = {name_of_program, ": ", reasonToEnd(), "\n"};
    for (const char* part : parts) {
      if (::write(STDERR_FILENO, part, std::strlen(part)) < 0) break;  // nobody is left to be told
    }
    try {
      results::cleanUpForGood();
    } catch (...) {  // without memory the next run removes what is left
    }
  } else if (nobody != pthread_self()) {
    while (true) ::pause();  // another thread cleans up and ends the process
  }
  std::_Exit(kFileFailed);
}

std::atomic<bool> at_work{false};

/// A library that calls exit, as OpenMP does without memory, ends the run like any other failure.
void whenExiting() {
  if (!at_work) return;
  std::atexit(whenExiting);  // for the next thread: each handler is called once, and exit goes on without it
  endAtOnce();
}

/// A stream that the caller has closed: else the next file that is opened would take its place, and what is printed.
/// What is written to it fails.
void openStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1) continue;
    const int opened = ::open("/dev/null", O_RDONLY);
    if (opened != stream && opened >= 0) ::close(opened);  // another one was free before
  }
}

/// A stack that libraries' products of matrices fit into, for threads too: Eigen keeps up to 128 kB of one there.
void ensureStack() {
  constexpr rlim_t kLeast = rlim_t{1} << 20;
  rlimit stack{};
  if (::getrlimit(RLIMIT_STACK, &stack) != 0 || stack.rlim_cur >= kLeast) return;
  if (stack.rlim_max < kLeast) {
    throw Error(Error::Kind::File, "memory", "the stack (ulimit -s)", std::to_string(stack.rlim_max >> 10) + " kB",
                std::to_string(kLeast >> 10) + " kB or more");
  }
  stack.rlim_cur = kLeast;
  pthread_attr_t threads;
  pthread_getattr_default_np(&threads);
  pthread_attr_setstacksize(&threads, kLeast);
  pthread_setattr_default_np(&threads);
  pthread_attr_destroy(&threads);
  ::setrlimit(RLIMIT_STACK, &stack);
}

/// As long as the work runs, nobody but it ends the process.
class AtWork {
 public:
  AtWork() {
    std::atexit(whenExiting);
    at_work = true;
  }
  ~AtWork() { at_work = false; }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
};

}  // namespace

int runMain(const char* program, const std::function<int()>& work, const std::function<std::string()>& after_failure) {
  const auto failed = [&](const std::string& reason, int status) {
    const std::string more = after_failure ? after_failure() : "";
    const std::string line = std::string(program) + ": " + printable(reason + more) + "\n";
    std::cerr << line;  // all of it or, where memory ends here, nothing
    return status;
  };
  try {
    name_of_program = program;
    openStandardStreams();
    ensureStack();
    std::set_terminate(endAtOnce);
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond what is allowed is a write that fails, as on a full disk
    Eigen::setNbThreads(1);  // OpenMP, by which Eigen has large products done, ends the process for want of a thread
    results::stopCleanly(program);
    const AtWork at_work_now;
    const int status = work();
    std::cout.flush();
    if (!std::cout)
      throw Error(Error::Kind::File, "output", "standard output", "not written", "room for what is printed");
    return status;
  } catch (const Error& error) {
    return failed(lineOf(error), error.kind() == Error::Kind::Option ? kWrongUse : kFileFailed);
  } catch (const std::bad_alloc&) {
    try {
      return failed(kNoMemory, kFileFailed);
    } catch (const std::bad_alloc&) {
      endAtOnce();
    }
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
