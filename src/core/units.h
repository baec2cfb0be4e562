#pragma once

#include <cmath>

namespace tank_datum {

// Files and people use degrees and arc-seconds, the library radians.
constexpr double kPi = 3.14159265358979323846;
constexpr double kTwoPi = 2.0 * kPi;
constexpr double kDegree = kPi / 180.0;    ///< [rad]
constexpr double kMetresPerFoot = 0.3048;  ///< [m]
/// To a ten-thousand-millionth of a degree, so that a third of a turn reads 120 and not 119.99999999999999.
inline double toDegrees(double radians) { return std::round(radians * (180.0 / kPi) * 1e10) / 1e10; }
inline double toRadians(double degrees) { return degrees * (kPi / 180.0); }
inline double toArcSeconds(double radians) { return 3600.0 * radians * (180.0 / kPi); }

}  // namespace tank_datum
