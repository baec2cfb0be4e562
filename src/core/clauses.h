#pragma once

#include <string>

namespace tank_datum {

/// Adds a clause to a message of several, parted by "; "; an empty one adds nothing.
inline void addClause(std::string& message, const std::string& clause) {
  if (!clause.empty()) message += (message.empty() ? "" : "; ") + clause;
}

}  // namespace tank_datum
