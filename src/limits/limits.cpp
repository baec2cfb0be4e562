#include "tank_datum/limits/limits.h"

#include <algorithm>
#include <charconv>

#include "io/csv.h"
#include "io/embedded.h"
#include "io/whole_file.h"
#include "limits/limit_formula.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

const std::vector<std::string> kColumns = {"code", "clause",   "name", "quantity",   "use",   "formula",  "at_most",
                                           "unit", "diameter", "roof", "foundation", "trust", "citation", "service"};
constexpr std::size_t kFewestColumns = 13;  // a file without the last one is for every service

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// A row under its column names, which refuses what it cannot be.
class LimitRow {
 public:
  LimitRow(const CsvRow& row, const std::string& file) : row_(row), file_(file) {
    if (row.cells.size() != kColumns.size() && row.cells.size() != kFewestColumns) {
      throw Error(Error::Kind::Option, "limits", placeOf(file, row), std::to_string(row.cells.size()) + " cells",
                  std::to_string(kFewestColumns) + " or " + std::to_string(kColumns.size()));
    }
  }

  const std::string& text(const std::string& column) const {
    static const std::string none;
    const auto at = static_cast<std::size_t>(std::find(kColumns.begin(), kColumns.end(), column) - kColumns.begin());
    return at < row_.cells.size() ? row_.cells[at] : none;
  }
  const std::string& required(const std::string& column) const {
    if (text(column).empty()) refuse(column, "some text");
    return text(column);
  }
  const std::string& oneOf(const std::string& column, const std::vector<std::string>& words) const {
    if (std::find(words.begin(), words.end(), text(column)) == words.end()) refuse(column, joined(words, " or "));
    return text(column);
  }
  [[noreturn]] void refuse(const std::string& column, const std::string& expected) const {
    throw Error(Error::Kind::Option, "limits", placeOf(file_, row_) + " " + column, "\"" + text(column) + "\"",
                expected);
  }

 private:
  const CsvRow& row_;
  const std::string& file_;
};

std::optional<double> numberFrom(const std::string& text) {
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !(value >= 0.0)) return {};
  return value;
}

DiameterRange rangeFrom(const LimitRow& row) {
  DiameterRange range;
  const std::string& text = row.text("diameter");
  if (text.empty()) return range;
  const char* expected = "an interval of metres such as [12,45) or (80,)";
  const auto comma = text.find(',');
  const bool closed = text.size() > 3 && (text.front() == '[' || text.front() == '(') &&
                      (text.back() == ']' || text.back() == ')') && comma != std::string::npos;
  if (!closed) row.refuse("diameter", expected);
  const std::string to = text.substr(comma + 1, text.size() - comma - 2);
  const auto from_value = numberFrom(text.substr(1, comma - 1)), to_value = numberFrom(to);
  if (!from_value || (!to.empty() && !to_value)) row.refuse("diameter", expected);
  range.from = *from_value;
  if (to_value) range.to = *to_value;
  range.with_from = text.front() == '[';
  range.with_to = text.back() == ']';
  if (!(range.from < range.to)) row.refuse("diameter", expected);
  return range;
}

Limit limitFrom(const LimitRow& row) {
  Limit limit;
  limit.code = row.required("code");
  limit.clause = row.text("clause");
  limit.name = row.required("name");
  limit.quantity = row.oneOf("quantity", knownQuantities());
  limit.judged = row.oneOf("use", {"judge", "show"}) == "judge";
  const auto formula = parseFormula(row.text("formula"));
  if (!formula) row.refuse("formula", "a product of numbers and D H Y E L S, such as 5.5 * L^2 * Y / E / H");
  limit.formula = *formula;
  if (!row.text("at_most").empty()) {
    const auto cap = numberFrom(row.text("at_most"));
    if (!cap) row.refuse("at_most", "a number >= 0 or nothing");
    limit.at_most = *cap;
  }
  limit.unit = row.oneOf("unit", {"m", "m/m", "1/m"});
  limit.diameter = rangeFrom(row);
  limit.roof = row.oneOf("roof", {"", "open", "fixed"});
  limit.foundation = row.oneOf("foundation", {"", "ringwall", "earth"});
  limit.trust = row.oneOf("trust", {"verified", "secondary", "unverified"});
  limit.citation = row.required("citation");
  limit.service = row.oneOf("service", {"", "new", "rebuilt", "in-service"});
  return limit;
}

}  // namespace

bool DiameterRange::holds(double diameter) const {
  return (with_from ? diameter >= from : diameter > from) && (with_to ? diameter <= to : diameter < to);
}

const std::vector<std::string>& knownQuantities() {
  static const std::vector<std::string> all = {
      "tilt_slope",     "tilt_height",    "second_difference", "curvature", "out_of_plane", "antipodal",
      "settlement_arc", "neighbour_bend", "neighbour_slope",   "slope_10m", "level_9m",     "level_3m",
      "level_total",    "roundness_foot", "roundness_above",   "plumbness", "top_ovality"};
  return all;
}

std::vector<Limit> parseLimits(const std::string& text, const std::string& file) {
  const std::vector<CsvRow> rows = csvRows(text);
  const std::vector<std::string> shorter(kColumns.begin(), kColumns.begin() + kFewestColumns);
  if (rows.empty() || (rows.front().cells != kColumns && rows.front().cells != shorter)) {
    throw Error(Error::Kind::Option, "limits", rows.empty() ? file : placeOf(file, rows.front()),
                rows.empty() ? "no lines" : "another header", "the header line " + joined(kColumns, ","));
  }
  if (rows.size() == 1) throw Error(Error::Kind::Option, "limits", file, "no limits", "a row per limit");
  std::vector<Limit> limits;
  for (std::size_t i = 1; i < rows.size(); ++i) limits.push_back(limitFrom(LimitRow(rows[i], file)));
  return limits;
}

const std::string& standardLimitsText() { return embedded::limits(); }

std::vector<Limit> readLimits(const std::string& path) { return parseLimits(wholeFile(path, "limits"), path); }

const std::vector<Limit>& standardLimits() {
  static const std::vector<Limit> limits = parseLimits(standardLimitsText(), "the limits of this version");
  return limits;
}

}  // namespace tank_datum
