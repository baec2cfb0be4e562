#pragma once

#include <optional>
#include <string>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// "k, 2, expected >= 3"; empty when nothing is refused.
inline std::string said(const std::optional<Refusal>& refused) {
  return refused ? refused->name + ", " + refused->value + ", expected " + refused->expected : "";
}

}  // namespace tank_datum
