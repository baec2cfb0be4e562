#pragma once

#include <string>
#include <vector>

#include "report/display.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// What a movement takes for given though nobody said so: keys of words, "movement.one_height" where both surveys must
/// share one height, "movement.one_level" one level.
std::vector<std::string> unsaidOf(const Movement& movement);

/// "MOVED: change of mean ..., change of tilt ..., out of plane ...; 250 of 327 stations moved. ...", in the words of
/// the report's page.
std::string movementText(const Movement& movement, const Display& display, const std::string& language);

}  // namespace tank_datum
