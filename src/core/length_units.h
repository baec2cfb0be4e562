#pragma once

#include <map>
#include <string>

#include "core/units.h"

namespace tank_datum {

/// Metres per unit of the input, by the name it has at the command line and in datum.json; us-ft
/// is the US survey foot.
inline const std::map<std::string, double> kUnits = {
    {"m", 1.0}, {"mm", 0.001}, {"ft", kMetresPerFoot}, {"in", 0.0254}, {"us-ft", 1200.0 / 3937.0}};

}  // namespace tank_datum
