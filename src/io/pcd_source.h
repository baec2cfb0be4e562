#pragma once

#include <memory>

#include "io/scan_source.h"

namespace tank_datum {

class InputFile;

/// The points of a PCD file.
/// @throws Error (File) as readPcdHeader
std::shared_ptr<const Scan::Source> pcdSource(std::shared_ptr<const InputFile> file, double metres_per_unit);

}  // namespace tank_datum
