#pragma once

#include <string>
#include <vector>

#include "core/normal95.h"
#include "tank_datum/limits/limits.h"

namespace tank_datum {

/// Rows that share code, clause and name: together they make one check.
using LimitTable = std::vector<const Limit*>;

std::vector<LimitTable> tablesOf(const std::vector<Limit>& limits);

/// Why a table has no row for a tank though all that it asks for is given.
inline const char* const kNoLimit = "the rule has no limit for such a tank";

/// Of a tank [m].
struct Diameter {
  double value;
  double sigma = 0.0;  ///< its standard error

  double least() const { return value - kNormal95 * sigma; }  ///< with 95 %
  double most() const { return value + kNormal95 * sigma; }
};

/// The rows for a tank of this diameter, that of its value first, null for none: more than one where its error leaves
/// open which it is. Where the first is none, why.
std::vector<const Limit*> rowsFor(const LimitTable& table, const TankFacts& facts, const Diameter& diameter,
                                  std::string& reason);

}  // namespace tank_datum
