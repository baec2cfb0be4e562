#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "options.h"

namespace tank_datum::synth {

/// A scene from JSON; what is not given keeps its default. A key "comment" is allowed everywhere.
/// @throws Error (Option) naming an unknown key or a value of the wrong type
SceneOptions sceneFromJson(const nlohmann::ordered_json& json);

/// Every option as used, with the names a scene file has.
nlohmann::ordered_json toJson(const SceneOptions& options);

/// @throws Error (File) when the file cannot be read or is no JSON
nlohmann::ordered_json readJson(const std::string& path);

/// readJson, then sceneFromJson.
SceneOptions readScene(const std::string& path);

}  // namespace tank_datum::synth
