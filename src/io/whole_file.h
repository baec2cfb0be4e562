#pragma once

#include <cstdint>
#include <string>

namespace tank_datum {

constexpr std::uint64_t kLargestText = std::uint64_t{1} << 28;  // bytes: a datum.json of 10 000 stations has a tenth

/// The bytes of a file that is read as a whole: a table, a file of options, the results of a run.
/// @param stage    of the message when it is refused
/// @param largest  bytes that it may have
/// @throws Error (File) when it is no regular file, cannot be read, is larger, or changes meanwhile
std::string wholeFile(const std::string& path, const std::string& stage, std::uint64_t largest = kLargestText);

}  // namespace tank_datum
