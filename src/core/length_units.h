#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "core/units.h"

namespace tank_datum {

/// Metres per unit of the input, by the name it has at the command line and in datum.json; us-ft
/// is the US survey foot.
inline const std::map<std::string, double> kUnits = {
    {"m", 1.0}, {"mm", 0.001}, {"ft", kMetresPerFoot}, {"in", 0.0254}, {"us-ft", 1200.0 / 3937.0}};

constexpr const char* kLengthWanted = "a length as 8, 8m, 26.25ft, 315in or 8000mm";

/// A length as people type it, "8", "8m", "26.25 ft" [m]; a number alone is metres. Nothing of other text.
inline std::optional<double> lengthOf(const std::string& typed) {
  double value = 0.0;
  const auto read = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  std::string unit(read.ptr, typed.data() + typed.size());
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  const auto known = kUnits.find(unit.empty() ? "m" : unit);
  if (read.ec != std::errc() || std::isnan(value) || known == kUnits.end()) return std::nullopt;
  return value * known->second;
}

}  // namespace tank_datum
