#include "io/ply_source.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/ply_header.h"
#include "io/record_source.h"
#include "io/setup_labels.h"
#include "io/text_rows.h"

namespace tank_datum {
namespace {

/// Which properties of the vertices are read.
struct Vertices {
  const PlyElement& element;
  std::array<std::size_t, 3> xyz{};
  std::optional<std::size_t> label;
};

std::optional<std::size_t> findProperty(const PlyElement& element, std::string_view name, const InputFile& file) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name != name) continue;
    if (found) throw fileError("properties of vertex", file.path(), std::string(name) + " twice", "it once");
    found = i;
  }
  return found;
}

const PlyElement& vertexElement(const PlyHeader& header, const InputFile& file) {
  const auto is_vertex = [](const PlyElement& element) { return element.name == "vertex"; };
  const auto count = std::count_if(header.elements.begin(), header.elements.end(), is_vertex);
  if (count != 1) {
    throw fileError("elements", file.path(), count == 0 ? "no vertex" : "several named vertex", "one element vertex");
  }
  return *std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
}

Vertices verticesOf(const PlyHeader& header, const InputFile& file) {
  Vertices vertices{vertexElement(header, file), {}, {}};
  if (vertices.element.hasLists()) {
    throw fileError("properties of vertex", file.path(), "a list", "single numbers");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto at = findProperty(vertices.element, std::string(1, "xyz"[axis]), file);
    if (!at) at = findProperty(vertices.element, std::string(1, "XYZ"[axis]), file);
    if (!at) throw fileError("properties of vertex", file.path(), std::string("no ") + "xyz"[axis], "x, y and z");
    vertices.xyz[axis] = *at;
  }
  for (const char* label : kSetupLabels) {
    if (!vertices.label) vertices.label = findProperty(vertices.element, label, file);
  }
  return vertices;
}

std::string labelFieldOf(const Vertices& vertices) {
  return vertices.label ? vertices.element.properties[*vertices.label].name : "";
}

Error countError(const InputFile& file, const PlyElement& element, std::uint64_t most) {
  return fileError("element " + echo(element.name), file.path(), std::to_string(element.count) + " in the header",
                   "at most " + std::to_string(most) + ", all that the file holds");
}

/// The bytes of a list's row from an offset on, by its lengths.
class ListWalk {
 public:
  ListWalk(const InputFile& file, std::uint64_t offset) : file_(file), offset_(offset) {}

  /// Goes behind a row; false when the file ends before.
  bool skipRow(const PlyElement& element) {
    for (const PlyProperty& property : element.properties) {
      std::uint64_t items = 1;
      if (property.is_list) {
        const auto length = next(property.length);
        if (!length) return false;
        items = *length;
      }
      const std::uint64_t bytes = items * static_cast<std::uint64_t>(property.number.size);
      if (bytes > file_.size() - offset_) return false;
      offset_ += bytes;
    }
    return true;
  }

  std::uint64_t offset() const { return offset_; }

 private:
  /// The list's length, which is below 2^32.
  std::optional<std::uint64_t> next(const StoredNumber& number) {
    const auto size = static_cast<std::size_t>(number.size);
    if (file_.size() - offset_ < size) return std::nullopt;
    if (offset_ < begin_ || offset_ + size > begin_ + buffer_.size()) {
      buffer_.resize(std::min<std::uint64_t>(kRead, file_.size() - offset_));
      begin_ = offset_;
      file_.read(begin_, buffer_.data(), buffer_.size());
    }
    Points length;
    const CoordinateColumn column{buffer_.data() + (offset_ - begin_), 0, number};
    decodeRows({column, column, column}, 1, {}, length);
    offset_ += size;
    if (length.front().x() < 0.0) return std::nullopt;
    return static_cast<std::uint64_t>(length.front().x());
  }

  static constexpr std::size_t kRead = std::size_t{1} << 20;
  const InputFile& file_;
  std::uint64_t offset_, begin_ = 0;
  std::vector<char> buffer_;
};

/// Where the vertices begin in a binary file.
std::uint64_t vertexOffset(const PlyHeader& header, const InputFile& file) {
  std::uint64_t offset = header.data_offset;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") break;
    if (element.hasLists()) {
      ListWalk walk(file, offset);
      for (std::uint64_t row = 0; row < element.count; ++row) {
        if (!walk.skipRow(element)) throw countError(file, element, row);
      }
      offset = walk.offset();
    } else if (const std::size_t bytes = element.rowBytes()) {
      const std::uint64_t most = (file.size() - offset) / bytes;
      if (element.count > most) throw countError(file, element, most);
      offset += element.count * bytes;
    }
  }
  return offset;
}

std::shared_ptr<const Scan::Source> binarySource(std::shared_ptr<const InputFile> file, const PlyHeader& header,
                                                 const Vertices& vertices, double metres_per_unit) {
  const PlyElement& element = vertices.element;
  std::vector<RecordColumn> columns;
  std::size_t offset = 0;
  for (const PlyProperty& property : element.properties) {
    columns.push_back({offset, property.number});
    offset += static_cast<std::size_t>(property.number.size);
  }
  const std::uint64_t begin = vertexOffset(header, *file);
  const std::uint64_t most = (file->size() - begin) / element.rowBytes();
  if (element.count > most) throw countError(*file, element, most);
  RecordRows records{begin, element.count, element.rowBytes(), {}, {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) records.xyz[axis] = columns[vertices.xyz[axis]];
  if (vertices.label) records.label = columns[*vertices.label];
  return recordSource(std::move(file), records, metres_per_unit, {labelFieldOf(vertices), false, {}});
}

std::shared_ptr<const Scan::Source> textSourceOf(std::shared_ptr<const InputFile> file, const PlyHeader& header,
                                                 const Vertices& vertices, double metres_per_unit) {
  const PlyElement& element = vertices.element;
  const TextColumns none;
  TextRows text{file, TextLines(*file, header.data_offset), none, {}, labelFieldOf(vertices)};
  std::uint64_t first = 0;
  for (const PlyElement& before : header.elements) {
    const std::uint64_t most = text.lines.count() - first;
    if (!before.properties.empty() && before.count > most) throw countError(*file, before, most);
    if (before.name == "vertex") break;
    if (!before.properties.empty()) first += before.count;
  }
  if (element.count > 0) text.sections.push_back({first, element.count, 0, {}, {}});
  const std::size_t last = std::max({vertices.xyz[0], vertices.xyz[1], vertices.xyz[2], vertices.label.value_or(0)});
  text.columns.meaning.assign(last + 1, TextColumns::kPassedOver);
  for (int axis = 0; axis < 3; ++axis) text.columns.meaning[vertices.xyz[static_cast<std::size_t>(axis)]] = axis;
  if (vertices.label) text.columns.meaning[*vertices.label] = TextColumns::kLabel;
  return textSource(std::move(text), metres_per_unit);
}

}  // namespace

std::shared_ptr<const Scan::Source> plySource(std::shared_ptr<const InputFile> file, double metres_per_unit) {
  const PlyHeader header = readPlyHeader(*file);
  const Vertices vertices = verticesOf(header, *file);
  if (header.encoding == PlyEncoding::Ascii) {
    return textSourceOf(std::move(file), header, vertices, metres_per_unit);
  }
  return binarySource(std::move(file), header, vertices, metres_per_unit);
}

}  // namespace tank_datum
