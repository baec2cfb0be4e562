#include "io/text_format.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string>

#include "io/setup_labels.h"
#include "io/text_number.h"
#include "io/words.h"

namespace tank_datum {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text, std::string_view ends) {
  const std::size_t first = text.find_first_not_of(ends);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(ends) - first + 1);
}

bool isNumber(std::string_view cell) {
  double value = 0.0;
  return !cell.empty() && parseNumber(cell.data(), cell.data() + cell.size(), value) == cell.data() + cell.size();
}

/// Whether a cell holds two numbers with blanks between them.
bool holdsTwoNumbers(std::string_view cell) {
  const std::size_t blank = cell.find_first_of(kBlanks);
  if (blank == cell.npos) return false;
  const std::string_view rest = trimmed(cell.substr(blank), kBlanks);
  return isNumber(cell.substr(0, blank)) && isNumber(rest.substr(0, rest.find_first_of(kBlanks)));
}

/// Whether a cell begins with a number and goes on with a comma.
bool hasInnerComma(std::string_view cell) {
  double value = 0.0;
  const char* const end = cell.data() + cell.size();
  const char* stop = cell.empty() ? nullptr : parseNumber(cell.data(), end, value);
  return stop != nullptr && stop != end && *stop == ',';
}

/// A name in lower case, without the unit behind it.
std::string plainName(std::string_view cell) {
  return inCase(trimmed(cell.substr(0, cell.find_first_of("[(")), " \t\r/#\"'_"), std::tolower);
}

/// Where one of the names stands; nothing when none does, and when one stands twice.
std::optional<std::size_t> findOnce(const std::vector<std::string>& names, std::initializer_list<const char*> wanted) {
  for (const char* name : wanted) {
    const auto count = std::count(names.begin(), names.end(), name);
    if (count > 1) return std::nullopt;
    if (count == 1) return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  if (separator == ' ') {
    for (const std::string_view word : splitWords(line, kBlanks)) cells.push_back(trimmed(word, "\""));
    return cells;
  }
  for (std::size_t begin = 0, end = 0; end != line.npos; begin = end + 1) {
    end = line.find(separator, begin);
    cells.push_back(trimmed(trimmed(line.substr(begin, end - begin), kBlanks), "\""));
  }
  return cells;
}

char separatorOf(std::string_view line) {
  if (line.find(';') != line.npos) return ';';
  if (line.find(',') != line.npos) {
    const auto cells = cellsOf(line, ',');
    return std::any_of(cells.begin(), cells.end(), holdsTwoNumbers) ? ' ' : ',';
  }
  const auto cells = cellsOf(line, '\t');
  const bool all_filled = std::none_of(cells.begin(), cells.end(), [](std::string_view cell) { return cell.empty(); });
  return cells.size() > 2 && all_filled ? '\t' : ' ';
}

bool beginsWithXyz(std::string_view line) {
  const auto cells = cellsOf(line, separatorOf(line));
  return cells.size() >= 3 && std::all_of(cells.begin(), cells.begin() + 3, isNumber);
}

bool hasDecimalCommas(std::string_view line) {
  const auto cells = cellsOf(line, separatorOf(line));
  if (cells.size() >= 3 && std::all_of(cells.begin(), cells.begin() + 3, hasInnerComma)) return true;
  std::string kinds;  // of each comma: b with a blank behind it, d with a digit
  for (std::size_t at = line.find(','); at != line.npos; at = line.find(',', at + 1)) {
    kinds += at + 1 < line.size() && isBlank(line[at + 1]) ? 'b' : 'd';
  }
  if (kinds.size() < 5 || kinds.size() % 2 == 0) return false;  // three coordinates with two commas between them
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] != (i % 2 == 0 ? 'd' : 'b')) return false;
  }
  return true;
}

std::optional<TextColumns> columnsNamed(std::string_view line, char separator) {
  auto cells = cellsOf(line, separator);
  if (!cells.empty() && (cells.front() == "#" || cells.front() == "//")) cells.erase(cells.begin());
  std::vector<std::string> names;
  std::transform(cells.begin(), cells.end(), std::back_inserter(names), plainName);
  const std::array<std::optional<std::size_t>, 3> xyz = {findOnce(names, {"x", "easting", "east", "e"}),
                                                         findOnce(names, {"y", "northing", "north", "n"}),
                                                         findOnce(names, {"z", "elevation", "elev", "height", "h"})};
  if (!xyz[0] || !xyz[1] || !xyz[2]) return std::nullopt;
  TextColumns columns{separator, {}};
  const auto name_at = [&columns](std::size_t at, int meaning) {
    if (columns.meaning.size() <= at) columns.meaning.resize(at + 1, TextColumns::kPassedOver);
    columns.meaning[at] = meaning;
  };
  for (int axis = 0; axis < 3; ++axis) name_at(*xyz[static_cast<std::size_t>(axis)], axis);
  for (const char* label : kSetupLabels) {
    const auto at = std::find(names.begin(), names.end(), label);
    if (at == names.end()) continue;
    name_at(static_cast<std::size_t>(at - names.begin()), TextColumns::kLabel);
    break;
  }
  return columns;
}

}  // namespace tank_datum
