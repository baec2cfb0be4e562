#pragma once

#include <optional>
#include <vector>

#include "foot/foot_candidates.h"

namespace tank_datum {

/// Which flat stretch the shell stands on at each of several places round the tank, chosen for all of them together.
/// Every place has stretches to choose from, with a cost each: how far from the shell it begins, how steep and how
/// rough it is, how far the shell is seen below it. The choice is the cheapest path round the tank on which neighbours
/// differ by no more than a datum does (Viterbi 1967); to choose none has its cost, and so has a step. Where runs of
/// places still stand at different levels, the dearer ones are dropped.
/// @param arc    between neighbouring places [m]
/// @param reach  of the sections [m]
/// @param between  null, or empty: takes at which places none is chosen, where others stand at different levels
/// @return  per place the number of the candidate, none where none is chosen
std::vector<std::optional<std::size_t>> chooseRoundRing(const std::vector<std::vector<FootCandidate>>& places,
                                                        double arc, double reach, std::vector<bool>* between = nullptr);

}  // namespace tank_datum
