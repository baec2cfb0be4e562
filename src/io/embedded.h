#pragma once

#include <string>

/// Text files of the sources that are part of the library (tank_datum_embed in src/CMakeLists.txt).
namespace tank_datum::embedded {

const std::string& limits();  ///< limits.csv

}  // namespace tank_datum::embedded
