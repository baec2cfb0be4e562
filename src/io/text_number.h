#pragma once

#include <string_view>

namespace tank_datum {

/// Between the numbers of a line; the last is the end of a line of Windows.
inline bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

inline const char* skipBlanks(const char* at, const char* end) {
  while (at != end && isBlank(*at)) ++at;
  return at;
}

/// The number at the beginning of [at, end): decimal with a point, nan or inf in any case, or what the C library of
/// Windows wrote for those, 1.#QNAN or -1.#IND00.
/// @return what follows it; null when there is none or it is too large for a double
const char* parseNumber(const char* at, const char* end, double& value);

/// A whole number from 0 on that fills the text between blanks; -1 when it is none, or above 2^63.
long long parseWhole(std::string_view text);

}  // namespace tank_datum
