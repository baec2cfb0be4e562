#pragma once

#include <string>

namespace tank_datum {

/// Writes a file of a result.
/// @throws Error (File) with what the system says
void writeTextFile(const std::string& path, const std::string& content);

}  // namespace tank_datum
