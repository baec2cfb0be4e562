#pragma once

#include <string>
#include <vector>

#include "options/run_options.h"

namespace tank_datum {

/// What the command line of tank_datum asks for.
struct Command : RunOptions {
  std::vector<std::string> scans;

  /// The files that go in: scans, or stations typed in.
  std::vector<std::string> inputs() const { return levelling.empty() ? scans : std::vector<std::string>{levelling}; }
};

/// Reads the arguments; --help, --version and --print-... print and exit.
/// @return true with `command` filled; false with `status` the exit status to leave with
bool parseCommandLine(int argc, char** argv, Command& command, int& status);

}  // namespace tank_datum
