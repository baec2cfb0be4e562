#pragma once

#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "io/pcd_notes.h"

namespace tank_datum {

/// One column of a PCD file.
struct PcdField {
  std::string name;
  char type = 'F';  ///< 'F' float, 'I' signed, 'U' unsigned
  int size = 4;     ///< bytes: 4 or 8 for 'F'; 1, 2, 4 or 8 else
};

/// What a file says of itself beside its points.
struct PcdHeading {
  std::string comment;                   ///< a line that readers skip, at the head of the file; none when empty
  std::array<double, 3> viewpoint = {};  ///< where the scanner stood, in the frame and units of the rows; zero: unknown
  PcdNotes notes = {};
};

/// Streams rows into a binary or ascii PCD in bounded memory. The file appears under its name only when commit()
/// returns; before that, and after a failure, only a temporary file exists beside it, which the destructor removes.
class PcdWriter {
 public:
  enum class Format { Ascii, Binary };

  /// @throws Error (File) when the file cannot be made
  PcdWriter(std::string path, std::vector<PcdField> fields, Format format = Format::Binary,
            const PcdHeading& heading = {});
  ~PcdWriter();
  PcdWriter(const PcdWriter&) = delete;
  PcdWriter& operator=(const PcdWriter&) = delete;

  /// Appends rows of fields.size() values each, converted to the fields' types.
  /// @throws Error (File) on a full disk
  void append(const std::vector<double>& row_major_values);

  /// Writes the final count into the header, closes and renames.
  /// @throws Error (File) naming the path
  void commit();

 private:
  std::string path_, temporary_;
  std::vector<PcdField> fields_;
  Format format_;
  std::uint64_t rows_ = 0;
  std::streamoff width_at_ = 0, points_at_ = 0;  ///< where the counts stand in the header
  std::ofstream out_;
};

/// Refuses a path whose place a new file must not take: that of a folder, or of a device such as /dev/null.
/// @throws Error (File) naming the path
void requireReplaceable(const std::string& path);

}  // namespace tank_datum
