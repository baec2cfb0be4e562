#pragma once

#include <memory>

#include "io/text_rows.h"

namespace tank_datum {

/// What a file may be, for messages.
inline constexpr const char* kKnownFormats =
    "PCD, LAS, PLY, PTX, PTS, or text whose columns are three numbers or named x, y and z";

/// Finds where the points of a text stand. It is
/// - PTX when two lines of one whole number come first: scan by scan its columns and rows, the scanner's position and
///   axes, a matrix of 4 x 4, then a line a point in the scanner's frame;
/// - PTS when one such line does: block by block the number of points, then a line a point; lines beyond that number
///   are points of the block too;
/// - else a line a point, after a header line or not. A header may be a comment.
/// Scans and blocks are setups, 0, 1, ..., when there are several.
/// @throws Error (File) naming the line, what stands there and what was expected
TextRows readTextLayout(std::shared_ptr<const InputFile> file);

}  // namespace tank_datum
