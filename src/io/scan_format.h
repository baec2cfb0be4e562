#pragma once

#include <memory>
#include <string>

#include "io/scan_source.h"

namespace tank_datum {

enum class ScanFormat { Pcd, Las, Laz, Ply, E57, Text };

class InputFile;

/// What a file is, by its content: its name does not count. What begins like none of the others is PCD or, when it
/// holds what could be a row of numbers or the names of x, y and z, text.
/// @throws Error (File) naming the formats known when it is none of them
ScanFormat formatOf(const InputFile& file);

/// The format of a file that somebody else must read, "E57" or "LAZ"; empty of others, and of what cannot be opened.
std::string foreignFormatOf(const std::string& path);

/// @throws Error (File) as the readers of the formats, and of a foreign one that options.foreign does not read
std::shared_ptr<const Scan::Source> openSource(std::shared_ptr<const InputFile> file, double metres_per_unit,
                                               const ScanOptions& options);

}  // namespace tank_datum
