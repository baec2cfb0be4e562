#pragma once

#include <functional>
#include <string>

namespace tank_datum {

/// SHA-256 of a file's bytes as 64 lower-case hexadecimal digits (FIPS 180-4), read in blocks.
/// @param wanted  asked before each megabyte; false: an empty string is returned at once
/// @throws Error (File) when the file cannot be read
std::string sha256OfFile(const std::string& path, const std::function<bool()>& wanted = {});

}  // namespace tank_datum
