#pragma once

#include <string>
#include <vector>

#include "tank_datum/trust/tank_tests.h"

namespace tank_datum {

/// The worst outcome among tests; Pass without any.
TestOutcome worstOf(const std::vector<TankTest>& tests);

/// The findings of those tests that have the worst outcome, one after the other.
std::string findingsOf(const std::vector<TankTest>& tests);

}  // namespace tank_datum
