#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/units.h"

namespace tank_datum {

/// Normal deviates that are the same on every machine: Box and Muller on a specified generator.
class Deviates {
 public:
  explicit Deviates(std::uint64_t seed) : generator_(seed) {}

  double operator()() {
    if (kept_ready_) {
      kept_ready_ = false;
      return kept_;
    }
    constexpr double kUnit = 1.0 / 18446744073709551616.0;
    const double u = (static_cast<double>(generator_()) + 0.5) * kUnit, v = static_cast<double>(generator_()) * kUnit;
    const double r = std::sqrt(-2.0 * std::log(std::min(u, 1.0)));
    kept_ = r * std::sin(kTwoPi * v), kept_ready_ = true;
    return r * std::cos(kTwoPi * v);
  }

 private:
  std::mt19937_64 generator_;
  double kept_ = 0.0;
  bool kept_ready_ = false;
};

}  // namespace tank_datum
