#include "io/words.h"

#include <algorithm>

namespace tank_datum {

std::vector<std::string_view> splitWords(std::string_view line, std::string_view blanks) {
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(blanks); at < line.size(); at = line.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string inCase(std::string_view word, int (*to_case)(int)) {
  std::string changed(word);
  for (char& c : changed) c = static_cast<char>(to_case(static_cast<unsigned char>(c)));
  return changed;
}

std::size_t byteOrderMarkOf(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.substr(0, kMark.size()) == kMark ? kMark.size() : 0;
}

}  // namespace tank_datum
