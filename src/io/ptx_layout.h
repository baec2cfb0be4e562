#pragma once

#include "io/text_rows.h"

namespace tank_datum {

/// Finds the scans of a PTX file. A scan's pose is its matrix, which stands for row vectors: point = (x, y, z, 1) * M.
/// The scanner stood at the position of the header, or where zeros stand there, at the matrix's; at zero it is not
/// known.
/// @throws Error (File) when a line is not as it should be there, when fewer lines follow than columns x rows, when a
///         matrix is not a rotation and a translation
void readPtx(TextRows& text);

}  // namespace tank_datum
