#pragma once

#include <functional>
#include <string>

namespace tank_datum {

/// What every program's main is: the exit status of its work. Whatever the work throws ends as one line on stderr and
/// a status of exit_status.h; a signal cleans up first.
/// What asks for memory belongs into the work, the command with its defaults too: nothing says what fails before it.
/// @param program        its name, which begins the line
/// @param work           by std::cref() where it captures more than two references, for which it would need memory
/// @param after_failure  what is added to the line, such as where the results of an earlier run are
int runMain(const char* program, const std::function<int()>& work,
            const std::function<std::string()>& after_failure = {});

}  // namespace tank_datum
