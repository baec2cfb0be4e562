#pragma once

#include <string>

namespace tank_datum {

/// A picture of a result as tank_datum_view draws it, which stands beside this program or in PATH.
/// @param folder  of results
/// @return a data URI; empty where there is no viewer, or no datum to draw. When the viewer draws none a line on stderr
///         says so.
std::string drawnPicture(const std::string& folder);

}  // namespace tank_datum
