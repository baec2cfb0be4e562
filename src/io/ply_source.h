#pragma once

#include <memory>

#include "io/scan_source.h"

namespace tank_datum {

class InputFile;

/// The points of a PLY file: the rows of its element vertex, of which x, y, z and, where it is there, the property
/// setup, scan_id or point_source_id are read. Other elements are passed over, before it and behind it.
/// @throws Error (File) as readPlyHeader, without such an element, with lists in it, and when the file is too short
std::shared_ptr<const Scan::Source> plySource(std::shared_ptr<const InputFile> file, double metres_per_unit);

}  // namespace tank_datum
