#pragma once

#include <optional>
#include <string>

#include "tank_datum/limits/limits.h"

namespace tank_datum {

/// A product of positive numbers and powers of the letters D H Y E L S, with * and / from left to right; nothing when
/// the text is no such product.
std::optional<LimitFormula> parseFormula(const std::string& text);

}  // namespace tank_datum
