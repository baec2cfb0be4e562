#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace tank_datum {

/// A number of a JSON file: null when it is not known.
inline nlohmann::ordered_json number(double value) {
  using Json = nlohmann::ordered_json;
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace tank_datum
