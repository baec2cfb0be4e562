#pragma once

#include <optional>
#include <string>

#include "core/plain_text.h"
#include "tank_datum/core/error.h"

namespace tank_datum {

/// A file that the system refused.
/// @param thing  what of it the message names
/// @param number  errno; 0: not known
inline Error refusedBySystem(const std::string& stage, const std::string& thing, const std::string& path, int number,
                             const std::string& expected) {
  const std::string reason = number != 0 ? systemText(number) : "failed";
  return {Error::Kind::File, stage, {thing, reason, expected, path, number}};
}

/// The same reason for what was meant to be done with a file.
/// @param thing  what of it the message names
inline Error reworded(const Error& error, const std::string& stage, const std::string& thing, const std::string& path,
                      const std::string& expected) {
  return {Error::Kind::File, stage, {thing, error.refused().value, expected, path, error.refused().system_error}};
}

/// @throws Error (Option) naming the refused option, if there is one
inline void refuseFirst(const std::optional<Refusal>& refused) {
  if (refused) throw Error(Error::Kind::Option, "options", *refused);
}

}  // namespace tank_datum
