#pragma once

#include <string_view>

namespace tank_datum {

/// The report's page, made at build time from src/report/ and the chart library: what stands before its data and what
/// follows them.
extern const std::string_view kPageBeforeData;
extern const std::string_view kPageAfterData;

}  // namespace tank_datum
