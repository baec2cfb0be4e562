#pragma once

#include <Eigen/Core>
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
  constexpr double kStep = 1e-5;  // [m]
  const auto steps = [&](int axis) {
    const double step = point[axis] / kStep;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(step + std::copysign(0.5, step)));
  };
  return static_cast<std::uint32_t>(mixed(steps(0) ^ mixed(steps(1) ^ mixed(steps(2)))));
}

}  // namespace tank_datum
