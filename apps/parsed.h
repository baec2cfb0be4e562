#pragma once

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "core/printable.h"
#include "exit_status.h"
#include "tank_datum/core/error.h"

namespace tank_datum {

/// Refuses an option whose value is empty, as an unset variable of a shell leaves it.
/// @throws Error (Option) naming it
inline void refuseEmptyValues(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i], before = argv[i - 1];
    const bool is_empty = word.empty() && i > 1 && before.size() > 1 && before.front() == '-';
    const bool ends_empty = word.size() > 3 && word.front() == '-' && word.back() == '=';
    if (!is_empty && !ends_empty) continue;
    const std::string flag = is_empty ? before : word.substr(0, word.size() - 1);
    throw Error(Error::Kind::Option, "command line", {flag, "an empty value", "a value, or no " + flag});
  }
}

/// Elsewhere - is standard output, which no folder can be.
/// @param instead  what else may be meant, behind "; "
inline void refuseDash(const std::string& output, const std::string& instead = "") {
  if (output != "-") return;
  throw Error(Error::Kind::Option, "command line", "--output", "-", "a folder, or ./- for one of that name" + instead);
}

/// Parses the command line of a program that has a name. Help and version are printed, a wrong line is refused in one.
/// @return false with `status` the exit status to leave with
inline bool parsed(CLI::App& app, int argc, char** argv, int& status) {
  refuseEmptyValues(argc, argv);
  try {
    app.parse(argc, argv);
    return true;
  } catch (const CLI::Success& asked) {  // --help, --version
    status = app.exit(asked);
  } catch (const CLI::ParseError& error) {
    std::cerr << app.get_name() << ": command line: " << printable(withShortWords(error.what())) << ", expected what "
              << app.get_name() << " --help lists\n";
    status = kWrongUse;
  }
  return false;
}

}  // namespace tank_datum
