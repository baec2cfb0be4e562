#include "limits/limit_tables.h"

#include <algorithm>

#include "core/clauses.h"

namespace tank_datum {

std::vector<LimitTable> tablesOf(const std::vector<Limit>& limits) {
  std::vector<LimitTable> tables;
  for (const Limit& limit : limits) {
    const auto same = std::find_if(tables.begin(), tables.end(), [&](const LimitTable& table) {
      const Limit& first = *table.front();
      return first.code == limit.code && first.clause == limit.clause && first.name == limit.name;
    });
    (same == tables.end() ? tables.emplace_back() : *same).push_back(&limit);
  }
  return tables;
}

namespace {

/// The row for a tank of this diameter [m], or why there is none.
const Limit* rowFor(const LimitTable& table, const TankFacts& facts, double diameter, std::string& reason) {
  bool roof_needed = false, foundation_needed = false;
  for (const Limit* limit : table) {
    if (!limit->diameter.holds(diameter)) continue;
    const bool roof = limit->roof.empty() || limit->roof == facts.roof;
    const bool foundation = limit->foundation.empty() || limit->foundation == facts.foundation;
    if (roof && foundation) return limit;
    roof_needed = roof_needed || (!roof && facts.roof.empty());
    foundation_needed = foundation_needed || (!foundation && facts.foundation.empty());
  }
  if (roof_needed) addClause(reason, "the type of roof is not given (option roof: open or fixed)");
  if (foundation_needed)
    addClause(reason, "the kind of foundation is not given (option foundation: ringwall or earth)");
  if (reason.empty()) reason = kNoLimit;
  return nullptr;
}

}  // namespace

std::vector<const Limit*> rowsFor(const LimitTable& table, const TankFacts& facts, const Diameter& diameter,
                                  std::string& reason) {
  std::vector<const Limit*> rows = {rowFor(table, facts, diameter.value, reason)};
  for (const double other : {diameter.least(), diameter.most()}) {
    std::string why;
    const Limit* row = rowFor(table, facts, other, why);
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(row);
  }
  return rows;
}

}  // namespace tank_datum
