#pragma once

#include <array>

namespace tank_datum {

/// What a field is called that tells the setups of a scanner apart, in any format; the first that is there counts.
inline constexpr std::array<const char*, 3> kSetupLabels = {"setup", "scan_id", "point_source_id"};

}  // namespace tank_datum
