#pragma once

#include <string>
#include <vector>

#include "report/display.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// How many checks ended how, then those that failed, the furthest beyond its limit first and second opinions last;
/// without any, the undecided one nearest to it.
std::string checkLines(const std::vector<Check>& checks, const Display& display);

/// The word, the check that it rests on, and how sure it is.
std::string verdictLine(const Analysis& analysis);

}  // namespace tank_datum
