#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/io/scan.h"

namespace TANK_DATUM_API tank_datum {

/// Which of a scan's points these are, for a caller who holds the scan in memory and wants his own rows back.
/// @param points  taken from the scan's blocks, bit for bit; of points with equal coordinates each gets a row of its
/// own
/// @return per point its place among the scan's finite points, counted from 0
/// @throws std::logic_error for a point that is not the scan's
std::vector<std::size_t> rowsOf(const Points& points, const Scan& scan);

}  // namespace tank_datum
