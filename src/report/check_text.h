#pragma once

#include <string>

#include "report/display.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// A check's code and its name in a language: "API 653 ballot curvature by trigonometric regression".
std::string checkTitle(const Check& check, const std::string& language);

/// A figure in the check's unit, as the report's page has it: "8.8 mm".
std::string checkFigure(double value, const Check& check, const Display& display);

/// "8.8 mm (95 %: 8.1 to 32.0 mm)"; without an interval the figure alone.
std::string checkFigureWithInterval(const Check& check, const Display& display, const std::string& language);

/// The rate whose limit may be reached first, or why there is none, as the report's page says it.
std::string limitRatesText(const LimitRates& rates, const Display& display, const std::string& language);

}  // namespace tank_datum
