#pragma once

#include <locale.h>

#include <charconv>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>

namespace tank_datum {

inline locale_t plainLocale() {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  return plain;
}

/// What an errno means, in English whatever the locale of the host program: "No such file or directory".
inline std::string systemText(int number) { return strerror_l(number, plainLocale()); }

/// std::vsnprintf with a decimal point and without separators of thousands, whatever the locale of the host program.
__attribute__((format(printf, 3, 0))) inline int vsnprintfPlain(char* text, std::size_t size, const char* format,
                                                                std::va_list values) {
  const locale_t hosts = uselocale(plainLocale());
  const int length = std::vsnprintf(text, size, format, values);
  uselocale(hosts);
  return length;
}

/// The same of values.
__attribute__((format(printf, 3, 4))) inline int snprintfPlain(char* text, std::size_t size, const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  const int length = vsnprintfPlain(text, size, format, values);
  va_end(values);
  return length;
}

/// All of what it writes, however long.
__attribute__((format(printf, 1, 0))) inline std::string vformatted(const char* format, std::va_list values) {
  std::va_list again;
  va_copy(again, values);
  std::string text(static_cast<std::size_t>(vsnprintfPlain(nullptr, 0, format, again)) + 1, '\0');
  va_end(again);
  vsnprintfPlain(text.data(), text.size(), format, values);
  text.pop_back();
  return text;
}

/// The same of values.
__attribute__((format(printf, 1, 2))) inline std::string formatted(const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  std::string text = vformatted(format, values);
  va_end(values);
  return text;
}

/// The shortest text that reads back as the same double; empty when it is not known.
inline std::string shortestText(double value) {
  if (!std::isfinite(value)) return {};
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
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
