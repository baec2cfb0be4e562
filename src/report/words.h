#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tank_datum {

/// What stands for `{name}` in words.
using Values = std::vector<std::pair<std::string, std::string>>;

/// The words of a key in a language, from src/report/page/words/, as the report's page has them; in English where the
/// language lacks them.
/// @throws Error (Option) for a key that English lacks
std::string say(const std::string& language, const std::string& key, const Values& values = {});

/// The same of a key that English may lack: then the words given.
std::string sayOr(const std::string& language, const std::string& key, const std::string& otherwise);

/// The languages there are words of: "de", "en", ...
std::vector<std::string> languages();

}  // namespace tank_datum
