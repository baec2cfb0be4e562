#pragma once

#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/plain_text.h"
#include "io/io_error.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

constexpr double kFarthestPlace = 1e8;                         ///< coordinates in any frame [m]
constexpr double kLargestSigma = 1000.0, kLeastSigma = 1e-15;  ///< [m]

/// A value of a datum.json that only a damaged one has.
struct OddValue {
  std::string value, expected;
};

inline double numberOr(const nlohmann::json& value, double otherwise) {
  return value.is_null() ? otherwise : value.get<double>();
}

/// A length [m].
inline double within(double largest, double length) {
  if (std::abs(length) > largest) throw OddValue{generalText(length), "at most " + generalText(largest) + " m"};
  return length;
}

inline double errorFrom(const nlohmann::json& value) { return within(kLargestSigma, numberOr(value, kUnknown)); }

inline void requireCount(std::size_t count, std::size_t most) {
  if (count > most) throw OddValue{std::to_string(count) + " entries", "at most " + std::to_string(most)};
}

/// The word, one of some.
inline std::string oneOfWords(const std::string& word, const std::vector<std::string>& known) {
  std::string all;
  for (const std::string& one : known) {
    if (word == one) return word;
    all += (all.empty() ? "" : ", ") + one;
  }
  throw OddValue{"\"" + echo(word) + "\"", "one of " + all};
}

}  // namespace tank_datum
