#pragma once

#include <CLI/CLI.hpp>
#include <iostream>

#include "core/printable.h"
#include "exit_status.h"

namespace tank_datum {

/// Parses the command line of a program that has a name. Help and version are printed, a wrong line is refused in one.
/// @return false with `status` the exit status to leave with
inline bool parsed(CLI::App& app, int argc, char** argv, int& status) {
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::Success& asked) {  // --help, --version
    status = app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::cerr << app.get_name() << ": command line: " << printable(error.what()) << ", expected what " << app.get_name()
              << " --help lists\n";
    status = kWrongUse;
  }
  return false;
}

}  // namespace tank_datum
