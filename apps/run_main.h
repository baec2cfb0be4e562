#pragma once

#include <functional>
#include <string>

namespace tank_datum {

/// What every program's main is: the exit status of its work. Whatever the work throws ends as one line on stderr and
/// a status of exit_status.h; a signal cleans up first.
/// @param program        its name, which begins the line
/// @param after_failure  what is added to the line, such as where the results of an earlier run are
int runMain(const std::string& program, const std::function<int()>& work,
            const std::function<std::string()>& after_failure = {});

}  // namespace tank_datum
