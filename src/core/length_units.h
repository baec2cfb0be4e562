#pragma once

#include <map>
#include <string>

namespace tank_datum {

/// Metres per unit of the input, by the name it has at the command line and in datum.json.
inline const std::map<std::string, double> kUnits = {{"m", 1.0}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}};

}  // namespace tank_datum
