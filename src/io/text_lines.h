#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "tank_datum/core/error.h"

namespace tank_datum {

class InputFile;

/// The lines of a text that hold something, numbered from 0: blank ones and comments, which begin with # or //, are
/// passed over. The text is cut into chunks at line ends, so that several threads can read it and any line is found.
class TextLines {
 public:
  /// Counts the lines, which needs a pass over the file.
  /// @param offset  bytes before the first line
  /// @throws Error (File) with a line above 64 KiB
  TextLines(const InputFile& file, std::uint64_t offset);

  std::uint64_t count() const { return first_lines_.back(); }
  std::uint64_t chunkCount() const { return first_lines_.size() - 1; }

  /// The number of the first line that begins in a chunk.
  std::uint64_t firstOf(std::uint64_t chunk) const { return first_lines_[chunk]; }

  /// The chunk in which a line begins, one of count().
  std::uint64_t chunkOf(std::uint64_t line) const;

  /// Reads the lines that begin in a chunk; the text is that of the buffer.
  std::string_view read(std::uint64_t chunk, std::vector<char>& buffer) const;

  /// An error about a line, by the number that an editor shows.
  Error error(std::uint64_t line, const std::string& value, const std::string& expected) const;

  const InputFile& file() const { return file_; }

 private:
  const InputFile& file_;
  std::uint64_t offset_;
  std::vector<std::uint64_t> first_lines_;  // of each chunk, and behind the last
};

/// Takes the next line that holds something from the text; nothing when there is none left.
std::optional<std::string_view> takeLine(std::string_view& text);

/// Walks over such lines one by one.
class TextCursor {
 public:
  explicit TextCursor(const TextLines& lines) : lines_(lines) {}

  /// Goes to a line; behind the last is fine.
  void seek(std::uint64_t line);

  /// The number of the line that next() gives.
  std::uint64_t line() const { return line_; }

  /// Valid until the next call; nothing behind the last.
  std::optional<std::string_view> next();

 private:
  const TextLines& lines_;
  std::vector<char> buffer_;
  std::uint64_t line_ = 0, chunk_ = 0;  // chunk_: the one behind the text held
  std::string_view text_;
};

}  // namespace tank_datum
