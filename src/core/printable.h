#pragma once

#include <algorithm>
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

/// A message with its overlong words cut, such as a number of thousands of digits; paths stay.
inline std::string withShortWords(const std::string& text) {
  constexpr std::size_t kLongest = 60;
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size() - 1) + 1;
    const std::string word = text.substr(begin, end - begin);
    std::size_t length = word.size();
    if (length > kLongest && word.find('/') == std::string::npos) {
      length = kLongest;
      while (length > 0 && (static_cast<unsigned char>(word[length]) & 0xc0U) == 0x80U) --length;  // inside a character
    }
    result += length < word.size() ? word.substr(0, length) + (word.back() == ' ' ? "... " : "...") : word;
    begin = end;
  }
  return result;
}

/// Whether a text holds characters that turn the direction of what follows (U+202A to U+202E, U+2066 to U+2069): a
/// reader sees other words than are there.
inline bool turnsDirection(const std::string& text) {
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    const auto last = static_cast<unsigned char>(text[i + 2]);
    if (text.compare(i, 2, "\xe2\x80") == 0 && last >= 0xaa && last <= 0xae) return true;
    if (text.compare(i, 2, "\xe2\x81") == 0 && last >= 0xa6 && last <= 0xa9) return true;
  }
  return false;
}

}  // namespace tank_datum
