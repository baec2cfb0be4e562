#pragma once

#include <nlohmann/json.hpp>

#include "truth.h"

namespace tank_datum::synth {

/// Fills lean, rounds and plumb of a tank whose side is known.
/// @param offset  of the output's frame [m]
void addShellTruth(const Tank& tank, int stations, const Eigen::Vector2d& offset, TruthTank& truth);

/// The section "shell" of a tank in truth.json: metres and degrees.
nlohmann::ordered_json shellTruthJson(const TruthTank& tank);

}  // namespace tank_datum::synth
