#pragma once

#include "io/input_file.h"
#include "io/pcd_header.h"

namespace tank_datum {

/// Holds the header's POINTS against the size of the file, before anything is allocated by it; reads
/// header.compressed_bytes.
/// @throws Error (File) when they do not agree, see readPcdHeader
void checkPcdSize(const InputFile& file, PcdHeader& header);

}  // namespace tank_datum
