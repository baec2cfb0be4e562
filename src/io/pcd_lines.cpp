#include "io/pcd_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <utility>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/words.h"

namespace tank_datum {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view kBlanks = " \t\r\v\f";

bool isKeyword(std::string_view word) {
  constexpr std::array<std::string_view, 10> kKeywords = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                                          "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
}

/// A keyword in upper case, by its present name.
std::string keywordOf(std::string_view word) {
  const std::string key = inCase(word, std::toupper);
  return key == "COLUMNS" ? "FIELDS" : key;
}

/// Takes one line in; true when it is the last (DATA).
bool addLine(std::string_view line, std::size_t line_number, PcdLines& lines) {
  Words words = splitWords(line, kBlanks);
  if (words.empty()) return false;
  if (words[0][0] == '#') {
    lines.comments.push_back(line.substr(line.find('#') + 1));
    return false;
  }
  std::string key = keywordOf(words[0]);
  if (!isKeyword(key)) {
    throw fileError("header line " + std::to_string(line_number), lines.path, "\"" + echo(line) + "\"",
                    "VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or DATA");
  }
  words.erase(words.begin());
  if (!lines.values.emplace(key, std::move(words)).second) {
    throw fileError(key, lines.path, "a second line " + std::to_string(line_number), "one line");
  }
  return key == "DATA";
}

}  // namespace

bool beginsWithPcdKeyword(std::string_view line) {
  const Words words = splitWords(line, kBlanks);
  return !words.empty() && isKeyword(keywordOf(words[0]));
}

const std::vector<std::string_view>& PcdLines::list(std::string_view key) const {
  const auto found = values.find(key);
  if (found == values.end()) throw fileError(std::string(key), path, "missing", "a line " + std::string(key));
  return found->second;
}

std::string_view PcdLines::word(std::string_view key) const {
  const Words& words = list(key);
  if (words.size() != 1) {
    throw fileError(std::string(key), path, std::to_string(words.size()) + " values", "one");
  }
  return words[0];
}

std::optional<std::uint64_t> PcdLines::number(std::string_view key) const {
  if (!has(key)) return std::nullopt;
  const std::string_view text = word(key);
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size()) {
    throw fileError(std::string(key), path, echo(text), "a whole number >= 0");
  }
  return value;
}

PcdLines splitPcdHeader(std::string_view text, const InputFile& file) {
  PcdLines lines;
  lines.path = file.path();
  std::size_t begin = byteOrderMarkOf(text);
  for (std::size_t number = 1; begin < text.size(); ++number) {
    const std::size_t newline = text.find('\n', begin);
    if (newline == text.npos && text.size() < file.size()) {
      throw fileError("header", file.path(), "no DATA line in " + std::to_string(text.size()) + " bytes",
                      "a PCD header");
    }
    const std::size_t end = std::min(newline, text.size());
    const bool last = addLine(text.substr(begin, end - begin), number, lines);
    begin = std::min(end + 1, text.size());
    lines.data_offset = begin;
    if (last) return lines;
  }
  throw fileError("header", file.path(), text.empty() ? "an empty file" : "no DATA line",
                  "a PCD header that ends in a line DATA");
}

}  // namespace tank_datum
