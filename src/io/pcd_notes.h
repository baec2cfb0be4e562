#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// Fields of a PCD file that hold x, y and z in the scan's frame where those called so are relative to an origin.
inline constexpr std::array<const char*, 3> kFullNames = {"full_x", "full_y", "full_z"};

constexpr std::size_t kLongestPcdHeader = 64 * 1024;  ///< bytes

/// What PCD has no place for, as comments in the header that tank_datum writes and reads, and others pass over:
///
///     # tank_datum: origin 300000 5000000 0         x, y and z are relative to this point of the scan's frame
///     # tank_datum: step 0.0001                     between neighbouring coordinates where they were measured
///     # tank_datum: setup 2 is north                what a label is called, to the end of the line
///     # tank_datum: setup 2 at 300010.5 5000003 1   where its scanner stood, in the scan's frame
///
/// Numbers are in the file's units.
struct PcdNotes {
  std::array<double, 3> origin = {};
  double step = 0.0;  ///< 0: what the fields' types say
  std::map<std::uint32_t, ScanBlocks::Setup> setups;

  /// The comments, each without its #.
  std::vector<std::string> lines() const;
};

/// @param comments  lines of a header without their #; those that are no notes are passed over
/// @throws Error (File) naming the note that cannot be read
PcdNotes readPcdNotes(const std::vector<std::string_view>& comments, const std::string& path);

}  // namespace tank_datum
