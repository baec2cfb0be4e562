#pragma once

namespace tank_datum {

/// Bend of a datum times the radius: n^2 A / R for n = 8 waves of amplitude A = R / 2000.
constexpr double kHighestWave = 0.03;

}  // namespace tank_datum
