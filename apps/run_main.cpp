#include "run_main.h"

#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "exit_status.h"
#include "flag_names.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

/// One line of a text, such as an exception's.
std::string oneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

}  // namespace

int runMain(const std::string& program, const std::function<int()>& work,
            const std::function<std::string()>& after_failure) {
  results::stopCleanly(program);
  const auto failed = [&](const std::string& reason, int status) {
    std::cerr << program << ": " << oneLine(reason) << (after_failure ? after_failure() : "") << "\n";
    return status;
  };
  try {
    return work();
  } catch (const Error& error) {
    return failed(lineOf(error), error.kind() == Error::Kind::Option ? kWrongUse : kFileFailed);
  } catch (const std::bad_alloc&) {
    return failed("memory: more than there is, expected a machine with more memory, or fewer points", kFileFailed);
  } catch (const std::filesystem::filesystem_error& error) {
    return failed("files: " + error.path1().string() + ", " + error.code().message() +
                      ", expected a path that can be read and written",
                  kFileFailed);
  } catch (const std::exception& error) {
    return failed(std::string("unexpected: ") + error.what() + ", expected no such failure: please report it",
                  kFileFailed);
  }
}

}  // namespace tank_datum
