#pragma once

#include <cstdint>
#include <vector>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// The points' indices along a Morton curve, so that what is next in order is near in space, and a search tree's leaves
/// stay in the cache from one query to the next (Morton 1966).
/// @param points  finite, at most 2^32 of them
std::vector<std::uint32_t> mortonOrder(const Points& points);

}  // namespace tank_datum
