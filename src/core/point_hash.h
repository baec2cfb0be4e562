#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tank_datum {

/// Finaliser of SplitMix64 (Steele et al. 2014).
inline std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// Of the coordinates in steps far above their rounding, so that the same tank in another frame has the same hashes.
inline std::uint32_t pointHash(const Eigen::Vector3d& point) {
  constexpr double kSteps = 1e5;  // per metre
  constexpr double kLast = 9e18;  // steps that 63 bits can count; damaged floats lie beyond
  const auto steps = [&](int axis) {
    const double step = std::clamp(point[axis] * kSteps, -kLast, kLast);
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(step + std::copysign(0.5, step)));
  };
  // odd factors without a common pattern; the finaliser spreads their sum
  const std::uint64_t sum =
      steps(0) * 0x9e3779b97f4a7c15ULL + steps(1) * 0xc2b2ae3d27d4eb4fULL + steps(2) * 0x165667b19e3779f9ULL;
  return static_cast<std::uint32_t>(mixed(sum));
}

}  // namespace tank_datum
