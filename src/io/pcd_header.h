#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/pcd_notes.h"

namespace tank_datum {

class InputFile;

enum class PcdEncoding { Ascii, Binary, BinaryCompressed };

/// One field of a PCD header and where it stands.
struct PcdColumn {
  std::string name;
  char type = 'F';              ///< 'F' float, 'I' signed, 'U' unsigned
  int size = 4;                 ///< bytes of one value
  std::int64_t count = 1;       ///< values of this field in a row
  std::size_t offset = 0;       ///< bytes before it in a binary row
  std::size_t first_value = 0;  ///< values before it in an ascii row
};

/// A PCD header that is consistent with itself and with the size of its file.
struct PcdHeader {
  std::vector<PcdColumn> columns;
  std::array<std::size_t, 3> xyz{};                ///< where x, y and z stand in columns
  PcdNotes notes;                                  ///< of the comments
  std::optional<std::size_t> label;                ///< where the field stands that tells setups apart, if there is one
  std::optional<std::array<double, 3>> viewpoint;  ///< in stored units; none where the line says 0 0 0 or is missing
  std::uint64_t points = 0;
  PcdEncoding encoding = PcdEncoding::Ascii;
  std::uint64_t data_offset = 0;  ///< bytes before the first row, or before the compressed block
  std::uint32_t compressed_bytes = 0;
  std::size_t row_bytes = 0;
  std::size_t row_values = 0;
};

/// Reads and checks the header of a PCD file, the rows not.
///
/// Header lines may come in any order, DATA last, keywords and the word after DATA in any case, after a byte order mark
/// or not. FIELDS (COLUMNS in old files), SIZE and TYPE are needed, and POINTS or WIDTH; COUNT and HEIGHT default to 1.
/// VERSION may be missing, else it is 0.5, 0.6 or 0.7 with or without the 0. VIEWPOINT is where the scanner stood, and
/// is not applied to the points. A field `setup`, `scan_id` or `point_source_id` of one value a row is the label of the
/// setup. x, y and z (or X, Y, Z) must be there once each with COUNT 1; other fields are free. Where full_x, full_y and
/// full_z stand beside them these are the coordinates, and the others those of an origin for who reads 4-byte floats
/// alone. One of COUNT 0 is not
/// there; one of a negative COUNT leads back in the row, as PCL writes it.
///
/// Refused: unknown or repeated keywords, WIDTH x HEIGHT other than POINTS, more POINTS than the file can hold, a
/// compressed block whose size is not POINTS rows, a header above 64 KiB, rows above 64 KiB. Bytes behind the last row
/// or the compressed block are passed over: PCL's writers fill the file up to a page.
/// @throws Error (File) naming the file, the keyword, the value met and what was expected
PcdHeader readPcdHeader(const std::string& path);

/// The same of a file already open (library-internal).
PcdHeader readPcdHeader(const InputFile& file);

}  // namespace tank_datum
