#include "io/text_lines.h"

#include <algorithm>
#include <cstring>

#include "core/parallel.h"
#include "io/input_file.h"
#include "io/io_error.h"
#include "io/text_number.h"

namespace tank_datum {
namespace {

constexpr std::size_t kChunkBytes = std::size_t{1} << 19;  // about kBlockRows rows of text
constexpr std::size_t kLongestLine = std::size_t{1} << 16;

bool holdsSomething(std::string_view line) {
  const char* end = line.data() + line.size();
  const char* at = skipBlanks(line.data(), end);
  if (at == end || *at == '#') return false;
  return !(*at == '/' && end - at > 1 && at[1] == '/');
}

/// Takes the next line, whatever it holds, with its end.
std::string_view takeAny(std::string_view& text) {
  const auto* newline = static_cast<const char*>(std::memchr(text.data(), '\n', text.size()));
  const std::size_t length = newline != nullptr ? static_cast<std::size_t>(newline - text.data()) + 1 : text.size();
  const std::string_view line = text.substr(0, length);
  text.remove_prefix(length);
  return line;
}

std::string_view withoutEnd(std::string_view line) {
  if (!line.empty() && line.back() == '\n') line.remove_suffix(1);
  return line;
}

}  // namespace

std::optional<std::string_view> takeLine(std::string_view& text) {
  while (!text.empty()) {
    const std::string_view line = withoutEnd(takeAny(text));
    if (holdsSomething(line)) return line;
  }
  return std::nullopt;
}

TextLines::TextLines(const InputFile& file, std::uint64_t offset) : file_(file), offset_(offset) {
  const std::uint64_t bytes = file.size() - std::min(offset, file.size());
  first_lines_.assign(bytes / kChunkBytes + 2, 0);
  forEachIndex(first_lines_.size() - 1, 0, [&](std::size_t chunk) {
    thread_local std::vector<char> buffer;
    std::string_view text = read(chunk, buffer);
    while (takeLine(text)) ++first_lines_[chunk + 1];
  });
  for (std::size_t i = 1; i < first_lines_.size(); ++i) first_lines_[i] += first_lines_[i - 1];
}

std::uint64_t TextLines::chunkOf(std::uint64_t line) const {
  const auto behind = std::upper_bound(first_lines_.begin(), first_lines_.end(), line);
  return static_cast<std::uint64_t>(behind - first_lines_.begin()) - 1;
}

std::string_view TextLines::read(std::uint64_t chunk, std::vector<char>& buffer) const {
  // a byte before the chunk tells whether a line begins with it; the last line ends behind it
  const std::size_t before = chunk == 0 ? 0 : 1;
  const std::uint64_t begin = offset_ + chunk * kChunkBytes - before;
  buffer.resize(before + kChunkBytes + kLongestLine);
  const std::size_t got = file_.readSome(begin, buffer.data(), buffer.size());
  const std::string_view all(buffer.data(), got);
  const std::size_t chunk_end = std::min(got, before + kChunkBytes);
  std::size_t first = 0, last = got;
  if (before != 0) first = std::min(chunk_end, all.substr(0, chunk_end).find('\n')) + 1;
  if (first > chunk_end) return {};
  if (chunk_end < got) {
    const std::size_t newline = all.find('\n', chunk_end - 1);
    if (newline == all.npos && got == buffer.size()) {
      throw fileError("a line", file_.path(), "above " + std::to_string(kLongestLine) + " bytes", "rows of numbers");
    }
    last = newline == all.npos ? got : newline + 1;
  }
  return all.substr(first, last - first);
}

Error TextLines::error(std::uint64_t line, const std::string& value, const std::string& expected) const {
  std::vector<char> buffer;
  const std::uint64_t chunk = chunkOf(std::min(line, count() - 1));
  std::uint64_t number = 1;
  for (std::uint64_t at = 0; at < offset_;) {
    buffer.resize(std::min<std::uint64_t>(kChunkBytes, offset_ - at));
    const std::size_t got = file_.readSome(at, buffer.data(), buffer.size());
    number += static_cast<std::uint64_t>(std::count(buffer.begin(), buffer.begin() + static_cast<long>(got), '\n'));
    at += buffer.size();
  }
  for (std::uint64_t i = 0; i < chunk; ++i) {
    const std::string_view text = read(i, buffer);
    number += static_cast<std::uint64_t>(std::count(text.begin(), text.end(), '\n'));
  }
  std::string_view text = read(chunk, buffer);
  for (std::uint64_t at = first_lines_[chunk]; !text.empty(); ++number) {
    if (holdsSomething(withoutEnd(takeAny(text))) && at++ == line) break;
  }
  return fileError("line " + std::to_string(number), file_.path(), value, expected);
}

void TextCursor::seek(std::uint64_t line) {
  const bool held = chunk_ > 0 && line >= line_ && line < lines_.firstOf(chunk_);
  if (!held) {
    chunk_ = line < lines_.count() ? lines_.chunkOf(line) : lines_.chunkCount();
    line_ = lines_.firstOf(chunk_);
    text_ = {};
  }
  while (line_ < line && next()) continue;
  line_ = line;
}

std::optional<std::string_view> TextCursor::next() {
  while (true) {
    if (const auto line = takeLine(text_)) {
      ++line_;
      return line;
    }
    if (chunk_ == lines_.chunkCount()) return std::nullopt;
    text_ = lines_.read(chunk_++, buffer_);
  }
}

}  // namespace tank_datum
