#pragma once

#include <cmath>
#include <cstdint>

#include "random.h"

namespace tank_datum::synth {

/// f(0) = 0, f(1) = 1, first and second derivative zero at both (Perlin 2002).
struct Fade {
  explicit Fade(double t)
      : value(t * t * t * (t * (t * 6.0 - 15.0) + 10.0)), rate(30.0 * t * t * (t * (t - 2.0) + 1.0)) {}
  double value, rate;
  static constexpr double kMaxRate = 1.875, kMaxBend = 5.7735;
};

/// A rough surface over the plane: random heights on a square lattice, joined C2.
class ValueNoise {
 public:
  struct Height {
    double value = 0.0, dx = 0.0, dy = 0.0;
  };

  ValueNoise() = default;

  /// @param rms     of the heights over the plane [m]
  /// @param length  side of the lattice, the correlation length [m]
  ValueNoise(std::uint64_t seed, double rms, double length) : seed_(seed), bound_(rms / kUnitRms), length_(length) {}

  Height at(double x, double y) const {
    if (bound_ == 0.0) return {};
    const double u = x / length_, v = y / length_;
    const double column = std::floor(u), row = std::floor(v);
    const Fade fx(u - column), fy(v - row);
    const auto i = static_cast<std::int64_t>(column), j = static_cast<std::int64_t>(row);
    const double h00 = lattice(i, j), h10 = lattice(i + 1, j), h01 = lattice(i, j + 1), h11 = lattice(i + 1, j + 1);
    const double low = h00 + (h10 - h00) * fx.value, high = h01 + (h11 - h01) * fx.value;
    const double dx = (h10 - h00) * (1.0 - fy.value) + (h11 - h01) * fy.value;
    return {low + (high - low) * fy.value, dx * fx.rate / length_, (high - low) * fy.rate / length_};
  }

  double bound() const { return bound_; }                              ///< largest |height| [m]
  double bend() const { return 16.0 * bound_ / (length_ * length_); }  ///< largest |second derivative| [1/m]

 private:
  double lattice(std::int64_t i, std::int64_t j) const {
    const std::uint64_t key = static_cast<std::uint64_t>(i) * 0x8da6b343d8163841ULL + static_cast<std::uint64_t>(j);
    return bound_ * (2.0 * unit(mixed(key ^ seed_)) - 1.0);
  }

  /// Of heights uniform in [-1, 1]: sqrt(1/3) * 2 * integral of Fade squared over [0, 1].
  static constexpr double kUnitRms = 0.57735026919 * 0.78354978355;

  std::uint64_t seed_ = 0;
  double bound_ = 0.0, length_ = 1.0;
};

}  // namespace tank_datum::synth
