#pragma once

#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The file of a survey: itself, or the datum.json in a result folder.
std::string epochFile(const std::string& path);

/// The survey in the text of a datum.json.
/// @param name  of the survey, for messages
/// @throws Error (File) what is no datum.json with its stations
Epoch epochIn(const std::string& datum_json, const std::string& name);

}  // namespace tank_datum
