#pragma once

#include <string>

namespace tank_datum {

/// Refuses the first line of a file of options that says nothing the command takes, each line judged by itself.
/// @throws Error (Option) naming file and line; Error (File) when it cannot be read
void requireConfigLines(const std::string& path);

}  // namespace tank_datum
