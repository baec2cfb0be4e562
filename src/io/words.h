#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tank_datum {

/// The parts of a line between any of the blanks.
std::vector<std::string_view> splitWords(std::string_view line, std::string_view blanks);

/// @param to_case  std::toupper or std::tolower
std::string inCase(std::string_view word, int (*to_case)(int));

/// Bytes of the byte order mark that a UTF-8 text begins with; 0 without one.
std::size_t byteOrderMarkOf(std::string_view text);

}  // namespace tank_datum
