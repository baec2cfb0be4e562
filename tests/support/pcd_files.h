#pragma once

#include <gtest/gtest.h>
#include <liblzf/lzf.h>
#include <stdlib.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "support/test_folder.h"
#include "tank_datum/core/error.h"

/// PCD files made byte by byte, without the project's own writer.
namespace tank_datum::pcd_files {

/// The name of a test that is instantiated for each encoding.
inline std::string nameOfEncoding(const testing::TestParamInfo<std::string>& info) { return info.param; }

using Folder = TestFolder;

inline std::string readAll(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct Field {
  std::string name;
  char type;
  int size;
  int count = 1;
};
using Row = std::vector<double>;  // as many values as the fields' counts together

inline const std::vector<Field> kXyzFloat = {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}};

inline std::string header(const std::vector<Field>& fields, std::size_t points, const std::string& data) {
  std::ostringstream names, sizes, types, counts, all;
  for (const Field& f : fields) {
    names << ' ' << f.name;
    sizes << ' ' << f.size;
    types << ' ' << f.type;
    counts << ' ' << f.count;
  }
  all << "# .PCD v0.7\nVERSION 0.7\nFIELDS" << names.str() << "\nSIZE" << sizes.str() << "\nTYPE" << types.str()
      << "\nCOUNT" << counts.str() << "\nWIDTH " << points << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << points
      << "\nDATA " << data << "\n";
  return all.str();
}

template <typename T>
std::string bytesOf(double value) {
  const T stored = static_cast<T>(value);
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &stored, sizeof(T));
  return bytes;
}

inline std::string bytesOf(double value, const Field& field) {
  const std::string key = field.type + std::to_string(field.size);
  if (key == "F4") return bytesOf<float>(value);
  if (key == "F8") return bytesOf<double>(value);
  if (key == "I1") return bytesOf<std::int8_t>(value);
  if (key == "I2") return bytesOf<std::int16_t>(value);
  if (key == "I4") return bytesOf<std::int32_t>(value);
  if (key == "I8") return bytesOf<std::int64_t>(value);
  if (key == "U1") return bytesOf<std::uint8_t>(value);
  if (key == "U2") return bytesOf<std::uint16_t>(value);
  if (key == "U4") return bytesOf<std::uint32_t>(value);
  return bytesOf<std::uint64_t>(value);
}

inline std::string asciiData(const std::vector<Row>& rows) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out << (i ? " " : "") << row[i];
    out << "\n";
  }
  return out.str();
}

inline std::string binaryData(const std::vector<Field>& fields, const std::vector<Row>& rows) {
  std::string bytes;
  for (const Row& row : rows) {
    std::size_t at = 0;
    for (const Field& f : fields) {
      for (int i = 0; i < f.count; ++i) bytes += bytesOf(row[at++], f);
    }
  }
  return bytes;
}

/// PCL's layout: all of the first field, then all of the second, ...; two sizes before the LZF block.
inline std::string compressedData(const std::vector<Field>& fields, const std::vector<Row>& rows) {
  std::string plain;
  std::size_t first = 0;
  for (const Field& f : fields) {
    const auto count = static_cast<std::size_t>(f.count);
    for (const Row& row : rows) {
      for (std::size_t i = 0; i < count; ++i) plain += bytesOf(row[first + i], f);
    }
    first += count;
  }
  std::string packed(2 * plain.size() + 64, '\0');
  const auto plain_size = static_cast<unsigned>(plain.size());
  packed.resize(lzf_compress(plain.data(), plain_size, packed.data(), static_cast<unsigned>(packed.size())));
  return bytesOf<std::uint32_t>(static_cast<double>(packed.size())) + bytesOf<std::uint32_t>(plain_size) + packed;
}

/// A whole file; data is "ascii", "binary" or "binary_compressed".
inline std::string pcd(const std::vector<Field>& fields, const std::vector<Row>& rows, const std::string& data) {
  return header(fields, rows.size(), data) + (data == "ascii"    ? asciiData(rows)
                                              : data == "binary" ? binaryData(fields, rows)
                                                                 : compressedData(fields, rows));
}

/// The message of the Error that call throws; fails when it throws none, or one of another kind.
inline std::string errorOf(const std::function<void()>& call, Error::Kind kind = Error::Kind::File) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_EQ(std::string(error.what()).find_first_of("\r\n\t"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind("io: ", 0), 0U) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no Error";
  return {};
}

/// The folder of real files, empty when there is none.
inline std::string dataFolder() {
  const char* folder = std::getenv("TANK_DATUM_DATA");
  return folder == nullptr ? "" : folder;
}

}  // namespace tank_datum::pcd_files
