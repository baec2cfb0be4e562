#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "io/input_file.h"
#include "io/io_error.h"
#include "io/words.h"

namespace tank_datum {
namespace {

constexpr std::size_t kLongestHeader = 64 * 1024;  // bytes
constexpr std::size_t kLongestRow = 64 * 1024;     // bytes
constexpr const char* kTypes =
    "char, uchar, short, ushort, int, uint, float or double, or a sized name such as float32";

using Words = std::vector<std::string_view>;

std::optional<StoredNumber> typeOf(std::string_view name) {
  struct Type {
    const char *old, *sized;
    StoredNumber number;
  };
  static const std::array<Type, 8> kNames = {{{"char", "int8", {'I', 1}},
                                              {"uchar", "uint8", {'U', 1}},
                                              {"short", "int16", {'I', 2}},
                                              {"ushort", "uint16", {'U', 2}},
                                              {"int", "int32", {'I', 4}},
                                              {"uint", "uint32", {'U', 4}},
                                              {"float", "float32", {'F', 4}},
                                              {"double", "float64", {'F', 8}}}};
  for (const Type& type : kNames) {
    if (name == type.old || name == type.sized) return type.number;
  }
  return std::nullopt;
}

/// Takes the lines of a header in, one by one.
class HeaderReader {
 public:
  explicit HeaderReader(const InputFile& file) : file_(file) {}

  /// False at the last line.
  bool take(std::string_view line) {
    ++number_;
    const Words words = splitWords(line, " \t\r");
    const std::string_view key = words.empty() ? std::string_view() : words[0];
    if (number_ == 1) {
      require(words.size() == 1 && key == "ply", line, "ply");
    } else if (key == "format") {
      takeFormat(words, line);
    } else if (key == "element") {
      takeElement(words, line);
    } else if (key == "property") {
      takeProperty(words, line);
    } else if (key == "end_header") {
      require(has_format_, line, "a line \"format\" before it");
      return false;
    } else {
      require(key.empty() || key == "comment" || key == "obj_info", line,
              "format, comment, obj_info, element, property or end_header");
    }
    return true;
  }

  PlyHeader header;

 private:
  void require(bool fine, std::string_view line, const std::string& expected) const {
    if (fine) return;
    throw fileError("header line " + std::to_string(number_), file_.path(), "\"" + echo(line) + "\"", expected);
  }

  void takeFormat(const Words& words, std::string_view line) {
    constexpr std::array<std::string_view, 3> kNames = {"ascii", "binary_little_endian", "binary_big_endian"};
    const auto name = std::find(kNames.begin(), kNames.end(), words.size() == 3 ? words[1] : std::string_view());
    require(name != kNames.end() && words[2] == "1.0" && !has_format_, line,
            "once format ascii, binary_little_endian or binary_big_endian 1.0");
    header.encoding = static_cast<PlyEncoding>(name - kNames.begin());
    has_format_ = true;
  }

  void takeElement(const Words& words, std::string_view line) {
    PlyElement element;
    require(has_format_, line, "a line \"format\" before it");
    bool fine = words.size() == 3;
    if (fine) {
      element.name = words[1];
      const auto [end, code] = std::from_chars(words[2].data(), words[2].data() + words[2].size(), element.count);
      fine = code == std::errc() && end == words[2].data() + words[2].size();
    }
    require(fine, line, "element NAME and a whole number >= 0");
    header.elements.push_back(std::move(element));
  }

  void takeProperty(const Words& words, std::string_view line) {
    require(!header.elements.empty(), line, "an element before it");
    PlyProperty property;
    property.is_list = words.size() == 5 && words[1] == "list";
    require(property.is_list || words.size() == 3, line, "property TYPE NAME or property list TYPE TYPE NAME");
    property.name = words.back();
    property.number = numberOf(words[words.size() - 2], line);
    if (property.is_list) {
      property.length = numberOf(words[2], line);
      require(property.length.type != 'F', line, "a list whose length is a whole number");
    }
    header.elements.back().properties.push_back(std::move(property));
    require(header.elements.back().rowBytes() <= kLongestRow, line,
            "rows of at most " + std::to_string(kLongestRow) + " bytes");
  }

  StoredNumber numberOf(std::string_view name, std::string_view line) const {
    const std::optional<StoredNumber> number = typeOf(name);
    require(number.has_value(), line, kTypes);
    StoredNumber stored = *number;
    stored.swapped = header.encoding == PlyEncoding::BigEndian;
    return stored;
  }

  const InputFile& file_;
  std::size_t number_ = 0;
  bool has_format_ = false;
};

}  // namespace

std::size_t PlyElement::rowBytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties) bytes += static_cast<std::size_t>(property.number.size);
  return bytes;
}

bool PlyElement::hasLists() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& one) { return one.is_list; });
}

PlyHeader readPlyHeader(const InputFile& file) {
  const std::string text = file.head(kLongestHeader);
  HeaderReader reader(file);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t newline = text.find('\n', begin);
    if (newline == text.npos) break;
    const bool more = reader.take(std::string_view(text).substr(begin, newline - begin));
    begin = newline + 1;
    if (more) continue;
    reader.header.data_offset = begin;
    return std::move(reader.header);
  }
  throw fileError("header", file.path(), "no line end_header in " + std::to_string(text.size()) + " bytes",
                  "a PLY header that ends in one");
}

}  // namespace tank_datum
