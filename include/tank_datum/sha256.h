#pragma once

#include <string>

#include "tank_datum/export.h"

namespace TANK_DATUM_API tank_datum {

/// SHA-256 of a file's bytes as 64 lower-case hexadecimal digits (FIPS 180-4), read in blocks.
/// @throws Error (File) when the file cannot be read
std::string sha256OfFile(const std::string& path);

}  // namespace tank_datum
