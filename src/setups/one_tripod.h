#pragma once

#include <cstdint>
#include <vector>

#include "setups/setup_adjustment.h"

namespace tank_datum {

/// Of each part of a merged cloud the number of the setup that it was scanned from, from 0 on in the order in which
/// they first appear: an overview and a detail of one tripod err alike. By what is likelier of two parts' errors, that
/// they are one setup's, or those of two (ratio of the density of their difference at none after the overlaps are seen,
/// to that before; J. M. Dickey, Ann. Math. Stat. 42, 1971), by far for every pair. Each a setup of its own where
/// overlaps do not tell what setups err by.
std::vector<std::uint16_t> setupsOfParts(const SetupAdjustment& adjusted);

}  // namespace tank_datum
