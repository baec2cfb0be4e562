#pragma once

#include <string>

namespace tank_datum {

/// Text from outside in one line for a terminal: control characters, which would steer it, become '?'; those that
/// UTF-8 writes as two bytes (U+0080 to U+009F) too.
inline std::string printable(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_c1 = i > 0 && text[i - 1] == '\xc2' && byte >= 0x80 && byte < 0xa0;
    if (is_c1) text[i - 1] = '?';
    if (is_c1 || byte < ' ' || byte == 0x7f) text[i] = '?';
  }
  return text;
}

/// The same of a text of several lines.
inline std::string printableLines(const std::string& text) {
  std::string lines;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    lines += printable(text.substr(begin, end - begin)) + "\n";
  }
  return lines + printable(text.substr(begin));
}

}  // namespace tank_datum
