#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/portable_math.h"
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
    const double r = std::sqrt(-2.0 * portable::log(std::min(u, 1.0)));
    kept_ = r * portable::sin(kTwoPi * v), kept_ready_ = true;
    return r * portable::cos(kTwoPi * v);
  }

 private:
  std::mt19937_64 generator_;
  double kept_ = 0.0;
  bool kept_ready_ = false;
};

/// What a scale that is estimated from residuals may be, over the estimate: the root of freedom over a chi-square
/// deviate, so that a normal deviate times it is Student's t. 1 for 0 degrees of freedom, which stand for a known
/// scale.
inline double studentWidth(Deviates& normal, double freedom) {
  constexpr int kMost = 200;
  const int squares = std::min(kMost, static_cast<int>(std::lround(freedom)));
  double sum = 0.0;
  for (int k = 0; k < squares; ++k) sum += square(normal());
  return squares > 0 ? std::sqrt(squares / sum) : 1.0;
}

}  // namespace tank_datum
