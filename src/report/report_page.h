#pragma once

#include <string>
#include <vector>

#include "tank_datum/report/report.h"

namespace tank_datum {

/// A text that the page carries inside itself: read by its scripts, and offered for download.
struct PageData {
  std::string id;       ///< what the page's scripts know it by; letters and underscores
  std::string type;     ///< media type, "application/json" or "text/csv"
  std::string content;  ///< UTF-8
};

/// JSON that may stand inside an HTML script element: `<`, `>`, `&`, U+2028 and U+2029 are written as JSON escapes,
/// which only strings can hold, so that it still reads back as the same JSON.
std::string escapedForScript(const std::string& json);

/// A page that opens from disk and needs nothing beside itself: the template with its styles, scripts and chart
/// library, and the data. Text reaches the page by way of JSON strings or escaped, never as markup.
/// @param plain  what a reader is told whose browser runs no scripts
/// @throws Error (Option) for CSV that holds `<`, which has no escape there
std::string pageWith(const std::vector<PageData>& data, const std::string& plain = "");

/// The page of several surveys of one tank, from movement.json and movement.csv.
/// @param logo  an image as a data URI, or empty
std::string trendPage(const std::string& movement_json, const std::string& movement_csv, const std::string& logo);

}  // namespace tank_datum
