#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum::synth {

/// splitmix64's mixing step (Steele, Lea, Flood 2014): every input bit reaches every output bit.
inline std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// One hash of several whole numbers, their order counting.
inline std::uint64_t mixed(std::initializer_list<std::uint64_t> keys) {
  std::uint64_t hash = 0x243f6a8885a308d3ULL;
  for (const std::uint64_t key : keys) hash = mixed(hash ^ key) + key;
  return hash;
}

/// Uniform in [0, 1).
inline double unit(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

/// A short stream of random numbers that depends on its keys alone, so any thread may draw it.
class Random {
 public:
  explicit Random(std::initializer_list<std::uint64_t> keys) : state_(mixed(keys)) {}

  double uniform() { return unit(mixed(state_ += 0x9e3779b97f4a7c15ULL)); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Standard normal (Box and Muller 1958); the second of each pair is kept.
  double gaussian() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double length = std::sqrt(-2.0 * portable::log(1.0 - uniform()));
    const double angle = kTwoPi * uniform();
    spare_ = length * portable::sin(angle);
    has_spare_ = true;
    return length * portable::cos(angle);
  }

 private:
  std::uint64_t state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace tank_datum::synth
