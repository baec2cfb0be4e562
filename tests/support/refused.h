#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// "k, 2, expected >= 3"; empty when nothing is refused.
inline std::string said(const std::optional<Refusal>& refused) {
  return refused ? refused->name + ", " + refused->value + ", expected " + refused->expected : "";
}

/// What a call refuses, as its message says it; empty when it does not.
template <typename Call>
std::string refusalOf(Error::Kind kind, const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return "";
}

}  // namespace tank_datum
