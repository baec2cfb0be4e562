#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/coordinates.h"

namespace tank_datum {

class InputFile;

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

/// One number of an element's row, or a list of them.
struct PlyProperty {
  std::string name;
  StoredNumber number;  ///< of a list its items
  bool is_list = false;
  StoredNumber length = {};  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes of a row in a binary file; nothing to say of one with lists.
  std::size_t rowBytes() const;
  bool hasLists() const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::uint64_t data_offset = 0;
  std::vector<PlyElement> elements;
};

/// Reads the header of a PLY file: lines that end with \n or \r\n, types by their old or their sized names. Source:
/// Turk, The PLY Polygon File Format, 1994.
/// @throws Error (File) naming the line, what stands there and what was expected
PlyHeader readPlyHeader(const InputFile& file);

}  // namespace tank_datum
