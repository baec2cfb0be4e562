#pragma once

#include <cstdarg>
#include <string>

#include "core/plain_text.h"

namespace tank_datum {

/// A line of the summary: its title, then what it says.
__attribute__((format(printf, 2, 3))) inline std::string line(const char* title, const char* format, ...) {
  std::va_list values;
  va_start(values, format);
  const std::string text = vformatted(format, values);
  va_end(values);
  return formatted("%-14s ", title) + text + "\n";
}

}  // namespace tank_datum
