#include "report/words.h"

#include <nlohmann/json.hpp>

#include "report/report_template.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

const nlohmann::json& allWords() {
  static const nlohmann::json words = nlohmann::json::parse(kWords);
  return words;
}

}  // namespace

std::string say(const std::string& language, const std::string& key, const Values& values) {
  const nlohmann::json& all = allWords();
  const bool spoken = all.contains(language) && all[language].contains(key);
  const nlohmann::json& words = all[spoken ? language : "en"];
  if (!words.contains(key)) throw Error(Error::Kind::Option, "words", key, "not there", "a key of en.json");
  std::string text = words[key];
  for (const auto& [name, value] : values) {
    const std::string place = "{" + name + "}";
    for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos; at += value.size()) {
      text.replace(at, place.size(), value);
    }
  }
  return text;
}

std::string sayOr(const std::string& language, const std::string& key, const std::string& otherwise) {
  return allWords()["en"].contains(key) ? say(language, key) : otherwise;
}

std::vector<std::string> languages() {
  std::vector<std::string> names;
  for (const auto& [name, words] : allWords().items()) names.push_back(name);
  return names;
}

}  // namespace tank_datum
