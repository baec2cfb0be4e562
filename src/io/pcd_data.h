#pragma once

#include <array>

#include "io/input_file.h"
#include "io/pcd_header.h"
#include "io/record_rows.h"

namespace tank_datum {

/// The rows of a binary file.
RecordRows recordRowsOf(const PcdHeader& header);

/// How x, y and z are stored, and where in a binary row.
std::array<RecordColumn, 3> xyzOf(const PcdHeader& header);

/// Visits the finite points of a binary_compressed file in file order. It is one LZF block and needs its compressed and
/// its uncompressed size of memory.
/// @return the rows seen, all of them unless the visitor ended the pass
/// @throws Error (File) when the data are not what the header says
ScanCounts visitCompressed(const InputFile& file, const PcdHeader& header, const Frame& frame,
                           const BlockVisitor& visit);

/// The same of an ascii file, with the memory of a block. Values are separated by blanks, tabs or one comma each; a row
/// has exactly header.row_values of them. Empty lines and those that begin with # are skipped, as is what follows the
/// last row and does not begin with a number. More rows than POINTS are refused as fewer are.
ScanCounts visitAscii(const InputFile& file, const PcdHeader& header, const Frame& frame, const BlockVisitor& visit);

}  // namespace tank_datum
