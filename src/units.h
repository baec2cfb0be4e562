#pragma once

namespace tank_datum {

// Files and people use degrees and arc-seconds, the library radians.
constexpr double kPi = 3.14159265358979323846;
constexpr double kTwoPi = 2.0 * kPi;
constexpr double toDegrees(double radians) { return radians * (180.0 / kPi); }
constexpr double toArcSeconds(double radians) { return 3600.0 * toDegrees(radians); }

}  // namespace tank_datum
