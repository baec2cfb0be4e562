#include "io/text_number.h"

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace tank_datum {
namespace {

/// Behind the # of a number that Windows wrote for one that is not finite; null if it is none.
const char* skipNotFinite(const char* at, const char* end) {
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  for (const std::string_view word : {"#INF", "#IND", "#QNAN", "#SNAN"}) {
    if (rest.substr(0, word.size()) != word) continue;
    at += word.size();
    while (at != end && *at == '0') ++at;
    return at;
  }
  return nullptr;
}

/// Whether it is written as infinite or not a number, not too large for a double.
bool isWord(const char* at) { return !(*at >= '0' && *at <= '9') && *at != '.'; }

}  // namespace

const char* parseNumber(const char* at, const char* end, double& value) {
  if (end - at > 1 && *at == '+' && at[1] != '-') ++at;
  const auto [stop, code] = fast_float::from_chars(at, end, value);
  if (code != std::errc()) return nullptr;
  if (stop != end && *stop == '#' && std::abs(value) == 1.0) {
    value = std::numeric_limits<double>::quiet_NaN();
    return skipNotFinite(stop, end);
  }
  if (std::isinf(value) && !isWord(*at == '-' ? at + 1 : at)) return nullptr;
  return stop;
}

long long parseWhole(std::string_view text) {
  const char* end = text.data() + text.size();
  const char* at = skipBlanks(text.data(), end);
  long long value = -1;
  const auto [stop, code] = std::from_chars(at, end, value);
  return code == std::errc() && skipBlanks(stop, end) == end && value >= 0 ? value : -1;
}

}  // namespace tank_datum
