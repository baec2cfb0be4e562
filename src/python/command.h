#pragma once

#include <string>
#include <vector>

namespace tank_datum::python {

// Defined in apps/python_command.cpp, beside the command itself.

/// Runs the command tank_datum or tank_datum_convert in this process, in a thread of its own without the interpreter's
/// lock; scans of formats that the library does not read go through the package's readers. Signals that Python handles
/// are heard within a tenth of a second.
/// @param words  the command line, the program's name first: that is which of them
/// @return the exit status
int runCommand(std::vector<std::string> words);

/// Ends the process by a signal as the command does: cleaned up, and with a line on stderr.
[[noreturn]] void stopCommandBy(int signal_number, const std::string& program);

}  // namespace tank_datum::python
