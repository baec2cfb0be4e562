#pragma once

#include <functional>
#include <optional>
#include <string>

#include "exit_status.h"
#include "results/result_folder.h"
#include "run_main.h"

namespace tank_datum {

/// runMain of a program that leaves results in its command's output folder: a failure's line says whose are there.
/// @param parse  parse(command, status): false with `status` the exit status to leave with
/// @param run    run(command, written): sets `written` when the results are; the exit status
template <typename Command, typename Parse, typename Run>
int runWithResults(const char* program, const Parse& parse, const Run& run) {
  std::optional<Command> command;
  bool written = false;
  const auto work = [&] {
    command.emplace();
    int status = kUsable;
    return parse(*command, status) ? run(*command, written) : status;
  };
  const auto left = [&] { return command ? resultsLeft(command->output, program, written) : std::string(); };
  return runMain(program, std::cref(work), std::cref(left));
}

}  // namespace tank_datum
