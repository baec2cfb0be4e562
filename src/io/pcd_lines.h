#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tank_datum {

class InputFile;

/// The text of a PCD header, split into keyword and values.
struct PcdLines {
  std::string path;
  std::map<std::string, std::vector<std::string_view>, std::less<>> values;  ///< keywords in upper case
  std::vector<std::string_view> comments;                                    ///< without their #
  std::uint64_t data_offset = 0;                                             ///< bytes up to the end of the line DATA

  bool has(std::string_view key) const { return values.count(key) != 0; }

  /// @throws Error (File) without a line of that keyword
  const std::vector<std::string_view>& list(std::string_view key) const;
  /// @throws Error (File) unless the line has one value
  std::string_view word(std::string_view key) const;
  /// The one value of a line as a number; nothing without the line.
  /// @throws Error (File) for any other value
  std::optional<std::uint64_t> number(std::string_view key) const;
};

/// @param text  the beginning of the file; it must outlive the lines
/// @throws Error (File) naming the file and the line that is none of a header
PcdLines splitPcdHeader(std::string_view text, const InputFile& file);

/// Whether the first word of a line is a keyword of the header, in any case.
bool beginsWithPcdKeyword(std::string_view line);

}  // namespace tank_datum
