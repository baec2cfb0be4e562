#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/text_rows.h"

namespace tank_datum {

/// The cells of a line, without the blanks and quotes round them.
std::vector<std::string_view> cellsOf(std::string_view line, char separator);

/// What parts the columns of a line of numbers or names: ';', ',', a tab, or ' ' for any blanks.
char separatorOf(std::string_view line);

/// Whether a line begins with three numbers.
bool beginsWithXyz(std::string_view line);

/// Whether commas stand in a line of numbers as decimal points: within its cells, which blanks, tabs or semicolons
/// part, or with a blank behind every second one.
bool hasDecimalCommas(std::string_view line);

/// The columns by the names of a header line: x, y and z, or easting, northing and elevation, and setup, scan_id or
/// point_source_id; nothing when it does not name the coordinates, each once.
std::optional<TextColumns> columnsNamed(std::string_view line, char separator);

}  // namespace tank_datum
