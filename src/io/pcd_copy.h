#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// What of a scan is copied, and what is said about it.
struct PcdCopy {
  std::function<bool(const Eigen::Vector3d& point)> wanted;  ///< asked of points relative to Scan::origin(); none: all
  std::function<void(std::uint64_t points)> progress;        ///< told how many have been looked at
  std::string comment;                                       ///< a line at the head of the file
};

/// Where x, y and z of a copy begin: a point near the origin whose coordinates are whole hundreds of metres, so that
/// 4-byte floats relative to it hold a tank to a hundredth of a millimetre.
Eigen::Vector3d localOrigin(const Eigen::Vector3d& origin);

/// Copies the finite points of a scan, in their order, into a binary PCD of 8-byte x, y, z [m] relative to a local
/// origin, and a field `setup`. With the notes in its head (PcdNotes) it is read as the scan is: coordinates, names and
/// places of setups and the coordinates' step are the same to the last bit.
/// @return the points copied
/// @throws Error (File); (Option) when the names of the setups do not fit into the head
std::uint64_t copyToPcd(const Scan& scan, const std::string& path, const PcdCopy& copy);

}  // namespace tank_datum
