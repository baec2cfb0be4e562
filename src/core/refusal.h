#pragma once

#include <optional>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// @throws Error (Option) naming the refused option, if there is one
inline void refuseFirst(const std::optional<Refusal>& refused) {
  if (refused) throw Error(Error::Kind::Option, "options", *refused);
}

}  // namespace tank_datum
