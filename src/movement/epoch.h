#pragma once

#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The file of a survey: itself, or the datum.json in a result folder.
std::string epochFile(const std::string& path);

}  // namespace tank_datum
