#pragma once

#include <locale.h>

#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <string>

namespace tank_datum {

/// std::snprintf with a decimal point and without separators of thousands, whatever the locale of the host program.
__attribute__((format(printf, 3, 4))) inline int snprintfPlain(char* text, std::size_t size, const char* format, ...) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  const locale_t hosts = uselocale(plain);
  std::va_list values;
  va_start(values, format);
  const int length = std::vsnprintf(text, size, format, values);
  va_end(values);
  uselocale(hosts);
  return length;
}

/// Six digits at most, as a stream without a locale prints a number: "0.25", "1e+06".
inline std::string generalText(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr};
}

/// So many digits behind the point; six, as std::to_string has them in a program without a locale. A zero has no minus.
inline std::string fixedText(double value, int digits = 6) {
  char buffer[400];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace tank_datum
