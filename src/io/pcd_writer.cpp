#include "io/pcd_writer.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/plain_text.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kCountWidth = 20;  // digits of the largest 64-bit count

Error wrongUse(const std::string& what, const std::string& value, const std::string& expected) {
  return Error(Error::Kind::Option, "io", what, value, expected);
}

Error writeError(const std::string& path) { return fileError("writing", path, errno, "a file that can be written"); }

/// Hidden, in the same folder (so that the rename is one step), unique among processes and within this one.
std::string temporaryName(const std::string& path) {
  static std::atomic<unsigned> counter{0};
  const std::filesystem::path target(path);
  const std::string suffix = "." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".tmp";
  return (target.parent_path() / ("." + target.filename().string() + suffix)).string();
}

void checkFields(const std::vector<PcdField>& fields) {
  if (fields.empty()) throw wrongUse("PcdWriter fields", "none", "at least one");
  for (const PcdField& f : fields) {
    if (f.name.empty() || f.name.find_first_of(" \t\r\n") != std::string::npos) {
      throw wrongUse("PcdWriter field name", "\"" + echo(f.name) + "\"", "a word");
    }
    const bool is_float = f.type == 'F' && (f.size == 4 || f.size == 8);
    const bool is_integer =
        (f.type == 'I' || f.type == 'U') && (f.size == 1 || f.size == 2 || f.size == 4 || f.size == 8);
    if (!is_float && !is_integer) {
      throw wrongUse("PcdWriter type of field " + f.name, std::string(1, f.type) + " " + std::to_string(f.size),
                     "F of 4 or 8 bytes, I or U of 1, 2, 4 or 8");
    }
  }
}

template <typename T>
void appendBinary(T value, std::string& out) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

/// Shortest text that reads back as the same value.
template <typename T>
void appendAscii(T value, std::string& out) {
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(value)) {
      out += "nan";  // never "-nan", which PCL does not know
      return;
    }
  }
  char text[40];
  const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
  out.append(text, end);
}

template <typename T>
T convert(double value, const PcdField& field) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    // 2^digits is exact in double where the largest T itself may not be
    const double above = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const double whole = std::nearbyint(value);
    const double lowest = std::is_signed_v<T> ? -above : 0.0;
    if (!(whole >= lowest && whole < above)) {
      throw wrongUse("PcdWriter value of field " + field.name, fixedText(value),
                     "a number that fits " + std::string(1, field.type) + " " + std::to_string(field.size));
    }
    return static_cast<T>(whole);
  }
}

template <typename T>
void appendAs(double value, const PcdField& field, bool ascii, std::string& out) {
  if (ascii) {
    appendAscii(convert<T>(value, field), out);
  } else {
    appendBinary(convert<T>(value, field), out);
  }
}

void appendValue(double value, const PcdField& field, bool ascii, std::string& out) {
  const bool is_signed = field.type == 'I';
  if (field.type == 'F') {
    field.size == 4 ? appendAs<float>(value, field, ascii, out) : appendAs<double>(value, field, ascii, out);
  } else if (field.size == 1) {
    is_signed ? appendAs<std::int8_t>(value, field, ascii, out) : appendAs<std::uint8_t>(value, field, ascii, out);
  } else if (field.size == 2) {
    is_signed ? appendAs<std::int16_t>(value, field, ascii, out) : appendAs<std::uint16_t>(value, field, ascii, out);
  } else if (field.size == 4) {
    is_signed ? appendAs<std::int32_t>(value, field, ascii, out) : appendAs<std::uint32_t>(value, field, ascii, out);
  } else {
    is_signed ? appendAs<std::int64_t>(value, field, ascii, out) : appendAs<std::uint64_t>(value, field, ascii, out);
  }
}

/// A count as long as any other, so that it can be written over; readers skip trailing blanks.
std::string paddedCount(std::uint64_t count) {
  std::string text = std::to_string(count);
  text.resize(kCountWidth, ' ');
  return text;
}

std::string commentsOf(const PcdHeading& heading) {
  std::vector<std::string> lines = heading.notes.lines();
  if (!heading.comment.empty()) lines.insert(lines.begin(), heading.comment);
  std::string text;
  for (const std::string& line : lines) {
    if (line.find('\n') != std::string::npos) throw wrongUse("PcdWriter comment", "\"" + echo(line) + "\"", "a line");
    text += "# " + line + "\n";
  }
  return text;
}

}  // namespace

void requireReplaceable(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw fileError("writing", path, std::filesystem::is_directory(status) ? "a folder" : "no regular file",
                  "a file, or the name of a new one");
}

PcdWriter::PcdWriter(std::string path, std::vector<PcdField> fields, Format format, const PcdHeading& heading)
    : path_(std::move(path)), temporary_(temporaryName(path_)), fields_(std::move(fields)), format_(format) {
  checkFields(fields_);
  requireReplaceable(path_);
  std::string names = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const PcdField& f : fields_) {
    names += " " + f.name;
    sizes += " " + std::to_string(f.size);
    types += std::string(" ") + f.type;
    counts += " 1";
  }
  std::string header = "# .PCD v0.7 - Point Cloud Data file format\n" + commentsOf(heading) + "VERSION 0.7\n" + names +
                       "\n" + sizes + "\n" + types + "\n" + counts + "\nWIDTH ";
  width_at_ = static_cast<std::streamoff>(header.size());
  header += paddedCount(0) + "\nHEIGHT 1\nVIEWPOINT ";
  for (const double at : heading.viewpoint) {
    appendAscii(at, header);
    header += ' ';
  }
  header += "1 0 0 0\nPOINTS ";
  points_at_ = static_cast<std::streamoff>(header.size());
  if (header.size() > kLongestPcdHeader - 100) {
    throw wrongUse("setups", std::to_string(heading.notes.setups.size()),
                   "so many that their names fit into " + std::to_string(kLongestPcdHeader) + " bytes");
  }
  header += paddedCount(0) + (format_ == Format::Ascii ? "\nDATA ascii\n" : "\nDATA binary\n");

  errno = 0;
  out_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!out_) throw writeError(path_);
  out_ << header;
}

PcdWriter::~PcdWriter() {
  if (temporary_.empty()) return;  // committed
  out_.close();
  std::remove(temporary_.c_str());
}

void PcdWriter::append(const std::vector<double>& row_major_values) {
  if (temporary_.empty()) throw wrongUse("PcdWriter::append", "called after commit()", "rows before commit()");
  const std::size_t columns = fields_.size();
  if (row_major_values.size() % columns != 0) {
    throw wrongUse("PcdWriter values", std::to_string(row_major_values.size()),
                   "a multiple of " + std::to_string(columns));
  }
  const bool ascii = format_ == Format::Ascii;
  std::string bytes;
  for (std::size_t i = 0; i < row_major_values.size(); ++i) {
    const std::size_t column = i % columns;
    appendValue(row_major_values[i], fields_[column], ascii, bytes);
    if (ascii) bytes += column + 1 == columns ? '\n' : ' ';
  }
  errno = 0;
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out_) throw writeError(path_);
  rows_ += row_major_values.size() / columns;
}

void PcdWriter::commit() {
  if (temporary_.empty()) throw wrongUse("PcdWriter::commit", "called twice", "one commit() per file");
  errno = 0;
  out_.seekp(width_at_);
  out_ << paddedCount(rows_);
  out_.seekp(points_at_);
  out_ << paddedCount(rows_);
  out_.close();  // flushes; a full disk shows here at the latest
  if (!out_) throw writeError(path_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) throw writeError(path_);
  temporary_.clear();
}

}  // namespace tank_datum
