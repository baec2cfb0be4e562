#pragma once

#include <string>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// @param first_error  of options: "name = value (must be what it should)", or empty when none is refused
/// @throws Error (Option) naming that option
inline void refuseFirst(const std::string& first_error) {
  if (first_error.empty()) return;
  const auto equals = first_error.find(" = "), must = first_error.find(" (must be ");
  throw Error(Error::Kind::Option, "options", first_error.substr(0, equals),
              first_error.substr(equals + 3, must - equals - 3),
              first_error.substr(must + 10, first_error.size() - must - 11));
}

}  // namespace tank_datum
