#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tank_datum {

/// The schema of datum.json and movement.json that this version writes; raised when a name or a unit changes.
constexpr int kSchema = 1;
constexpr int kFirstSchema = 1;  ///< that there was

/// A JSON file that a run of this project wrote.
/// @param stage     of the message when it is refused
/// @param expected  what the caller asks for, for that message
/// @throws Error (File) when it cannot be read, is no JSON, or has a newer schema than this version knows
nlohmann::json readJson(const std::string& path, const std::string& stage, const std::string& expected);

}  // namespace tank_datum
