#pragma once

#include <vector>

#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Of circles that lie one in the other leaves the tank: not a shell found twice, nor a ringwall, a bund wall round a
/// tank or a thing inside of one.
void dropNested(std::vector<Tank>& tanks);

}  // namespace tank_datum
