#include "io/scan_format.h"

#include <algorithm>
#include <string_view>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/las_header.h"
#include "io/pcd_lines.h"
#include "io/pcd_source.h"
#include "io/ply_source.h"
#include "io/record_source.h"
#include "io/text_format.h"
#include "io/text_layout.h"
#include "io/text_number.h"
#include "io/words.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kHead = 64 * 1024;  // bytes that are looked at

bool startsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

bool beginsLikePly(std::string_view head) {
  return startsWith(head, "ply") && head.size() > 3 && (head[3] == '\n' || isBlank(head[3]));
}

/// LASzip sets the upper bits of the point format.
bool isCompressedLas(std::string_view head) {
  constexpr std::size_t kFormat = 104;  // the byte of the header that has it
  constexpr unsigned kCompressed = 0xc0;
  return head.size() > kFormat && (static_cast<unsigned char>(head[kFormat]) & kCompressed) != 0;
}

bool isControl(char c) { return c >= '\0' && c < ' ' && c != '\t' && c != '\r' && c != '\n' && c != '\f'; }

/// Whether a line ends in CR alone, as of old Macintoshes and of spreadsheets that still write so.
bool hasBareCarriageReturn(std::string_view head) {
  for (std::size_t i = 0; i + 1 < head.size(); ++i) {
    if (head[i] == '\r' && head[i + 1] != '\n' && head[i + 1] != '\r') return true;
  }
  return false;
}

/// Whether the columns of a header line are named, the first of them too: "height easting northing".
bool namesColumnsFromTheFirst(std::string_view line) {
  const auto columns = columnsNamed(line, separatorOf(line));
  return columns && columns->meaning.front() != TextColumns::kPassedOver;
}

/// Whether a line is one of a PCD header: of those that hold something the first, or the comment that PCL begins with.
bool beginsLikePcd(std::string_view head) {
  head.remove_prefix(byteOrderMarkOf(head));
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    head.remove_prefix(std::min(head.size(), line.size() + 1));
    const std::size_t first = line.find_first_not_of(" \t\r\v\f");
    if (first == line.npos) continue;
    if (line[first] != '#') return beginsWithPcdKeyword(line) && !namesColumnsFromTheFirst(line);
    if (line.find(".PCD") != line.npos) return true;
  }
  return false;
}

std::shared_ptr<const Scan::Source> lasSource(std::shared_ptr<const InputFile> file, double metres_per_unit,
                                              const ScanOptions& options) {
  const RecordRows records = readLasHeader(*file, options.las_classes);
  return recordSource(std::move(file), records, metres_per_unit, {"point_source_id", true, {}});
}

/// What somebody else reads.
std::shared_ptr<const Scan::Source> foreignSource(const ForeignScan& scan, const ScanOptions& options) {
  if (options.foreign) return streamSource(options.foreign(scan));
  throw fileError("format", scan.path, scan.format,
                  std::string(kKnownFormats) + "; the Python package reads it: pip install 'tank_datum[formats]'");
}

}  // namespace

ScanFormat formatOf(const InputFile& file) {
  const std::string head = file.head(kHead);
  if (head.empty()) throw fileError("header", file.path(), "an empty file", kKnownFormats);
  if (startsWith(head, "LASF")) return isCompressedLas(head) ? ScanFormat::Laz : ScanFormat::Las;
  if (beginsLikePly(head)) return ScanFormat::Ply;
  if (startsWith(head, "ASTM-E57")) return ScanFormat::E57;
  if (beginsLikePcd(head)) return ScanFormat::Pcd;
  if (startsWith(head, "\xff\xfe") || startsWith(head, "\xfe\xff")) {
    throw fileError("format", file.path(), "UTF-16 text", "UTF-8 or ASCII text");
  }
  if (std::any_of(head.begin(), head.end(), isControl)) {
    throw fileError("format", file.path(), "\"" + echo(head.substr(0, 12)) + "\"", kKnownFormats);
  }
  if (hasBareCarriageReturn(head)) {
    throw fileError("format", file.path(), "lines that end in CR alone",
                    "lines that end in LF or CR LF: tr '\\r' '\\n' < FILE");
  }
  return ScanFormat::Text;
}

std::string foreignFormatOf(const std::string& path) {
  try {
    const ScanFormat format = formatOf(InputFile(path));
    return format == ScanFormat::E57 ? "E57" : format == ScanFormat::Laz ? "LAZ" : "";
  } catch (const Error&) {
    return "";
  }
}

std::shared_ptr<const Scan::Source> openSource(std::shared_ptr<const InputFile> file, double metres_per_unit,
                                               const ScanOptions& options) {
  const std::string path = file->path();
  const ScanFormat format = formatOf(*file);
  if (!options.las_classes.empty() && format != ScanFormat::Las && format != ScanFormat::Laz) {
    throw Error(Error::Kind::Option, "io", "las_classes", "given for " + path, "LAS files: others have no classes");
  }
  switch (format) {
    case ScanFormat::Pcd:
      return pcdSource(std::move(file), metres_per_unit);
    case ScanFormat::Las:
      return lasSource(std::move(file), metres_per_unit, options);
    case ScanFormat::Ply:
      return plySource(std::move(file), metres_per_unit);
    case ScanFormat::Laz:
      return foreignSource({path, "LAZ", metres_per_unit, options.las_classes}, options);
    case ScanFormat::E57:
      return foreignSource({path, "E57", metres_per_unit, options.las_classes}, options);
    case ScanFormat::Text:
      return textSource(readTextLayout(std::move(file)), metres_per_unit);
  }
  return nullptr;
}

}  // namespace tank_datum
