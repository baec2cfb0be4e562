#pragma once

#include <string>
#include <string_view>

#include "core/printable.h"
#include "core/refusal.h"
#include "tank_datum/core/error.h"

namespace tank_datum {

/// A value met in a file, fit for a one-line message: what is not printable ASCII becomes '?', the rest is cut.
inline std::string echo(std::string_view value) {
  constexpr std::size_t kLongest = 40;
  std::string text(value.substr(0, kLongest));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return value.size() > kLongest ? text + "..." : text;
}

/// A path in full, without control characters; UTF-8 stays.
inline std::string echoPath(std::string path) { return printable(std::move(path)); }

/// Error of the kind File, stage "io", about a thing (such as "POINTS") of a file.
inline Error fileError(const std::string& thing, const std::string& path, const std::string& value,
                       const std::string& expected) {
  return {Error::Kind::File, "io", {thing + " of " + echoPath(path), value, expected, path}};
}

/// The same of a file that the system refused, for the reason in errno.
inline Error fileError(const std::string& thing, const std::string& path, int number, const std::string& expected) {
  return refusedBySystem("io", thing + " of " + echoPath(path), path, number, expected);
}

}  // namespace tank_datum
