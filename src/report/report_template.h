#pragma once

#include <string_view>

namespace tank_datum {

/// The report's page, made at build time from src/report/ and the chart library: what stands before its data and what
/// follows them.
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageAfterData;

/// {"en": {key: words}, ...}, as the page has them.
extern const std::string_view kWords;

}  // namespace tank_datum
