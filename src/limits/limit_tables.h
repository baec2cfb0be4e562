#pragma once

#include <string>
#include <vector>

#include "tank_datum/limits/limits.h"

namespace tank_datum {

/// Rows that share code, clause and name: together they make one check.
using LimitTable = std::vector<const Limit*>;

std::vector<LimitTable> tablesOf(const std::vector<Limit>& limits);

/// Why a table has no row for a tank though all that it asks for is given.
inline const char* const kNoLimit = "the rule has no limit for such a tank";

/// The row for a tank of this diameter [m], or why there is none.
const Limit* rowFor(const LimitTable& table, const TankFacts& facts, double diameter, std::string& reason);

}  // namespace tank_datum
