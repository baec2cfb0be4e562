#pragma once

#include <string>

namespace tank_datum {

/// A decimal year as "2031-04", as dates of limits are said.
std::string monthOf(double year);

}  // namespace tank_datum
