#include "options/option_json.h"

#include <cmath>

namespace tank_datum {
namespace {

using Json = nlohmann::ordered_json;

struct ValueJson {
  const Option& option;

  Json operator()(const bool* value) const { return *value; }
  Json operator()(const int* value) const { return *value; }
  Json operator()(const std::size_t* value) const { return *value; }
  Json operator()(const double* value) const { return option.typed(*value); }
  Json operator()(const std::vector<double>* values) const { return *values; }
  Json operator()(const std::vector<int>* values) const { return *values; }
  Json operator()(const std::vector<std::string>* values) const { return *values; }
  Json operator()(const Fact& fact) const { return std::isfinite(*fact.value) ? Json(*fact.value) : Json(nullptr); }
  Json operator()(const Path& path) const { return path.path->empty() ? Json(nullptr) : Json(*path.path); }
  Json operator()(const std::optional<Circle>* circle) const {
    if (!*circle) return nullptr;
    return {(*circle)->center.x(), (*circle)->center.y(), (*circle)->radius};
  }
  Json operator()(const Places& places) const {
    Json all = Json::object();
    for (const auto& [name, at] : *places.places) all[name] = {at.x(), at.y(), at.z()};
    return all;
  }
  Json operator()(const Choice& choice) const {
    const std::string word = choice.get();
    return word.empty() ? Json(nullptr) : Json(word);
  }
};

struct Kind {
  const Option& option;

  std::string operator()(const bool*) const { return "flag"; }
  std::string operator()(const int*) const { return "integer"; }
  std::string operator()(const std::size_t*) const { return "integer"; }
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const std::vector<double>*) const { return "numbers"; }
  std::string operator()(const std::vector<int>*) const { return "integers"; }
  std::string operator()(const std::vector<std::string>*) const { return "names"; }
  std::string operator()(const std::optional<Circle>*) const { return "circle"; }
  std::string operator()(const Fact&) const { return option.unit == Unit::Metres ? "length" : "fact"; }
  std::string operator()(const Path& path) const { return path.folder ? "folder" : "file"; }
  std::string operator()(const Places&) const { return "places"; }
  std::string operator()(const Choice&) const { return "choice"; }
};

void putInto(Json& json, const std::vector<Option>& options) {
  for (const Option& option : options) {
    const std::size_t dot = option.place.find('.');
    if (option.place.empty()) continue;
    Json& section = dot == std::string::npos ? json : json[option.place.substr(0, dot)];
    section[dot == std::string::npos ? option.place : option.place.substr(dot + 1)] =
        std::visit(ValueJson{option}, option.value);
  }
}

Json listed(const Option& option) {
  Json json = {{"name", option.name},
               {"place", option.place.empty() ? Json(nullptr) : Json(option.place)},
               {"topic", option.topic},
               {"kind", std::visit(Kind{option}, option.value)},
               {"default", std::visit(ValueJson{option}, option.value)},
               {"expected", option.expected().empty() ? Json(nullptr) : Json(option.expected())},
               {"help", option.text()}};
  if (const auto* choice = std::get_if<Choice>(&option.value)) json["words"] = choice->words;
  if (option.letter != 0) json["letter"] = std::string(1, option.letter);
  json["negatable"] = option.negatable;
  json["configurable"] = option.configurable;
  json["command_only"] = option.giver == Giver::Command;
  return json;
}

}  // namespace

Json optionsJson(const RunOptions& given) {
  RunOptions run = given;
  Json json;
  // what the chain asks first stands first, whatever the order of the table
  for (const char* section :
       {"method", "locate", "crop", "normals", "growing", "centre_filter", "spline", "setups", "refine", "stations",
        "analysis", "shell", "pick", "accept", "level", "up", "las_classes", "tank"}) {
    json[section] = nullptr;
  }
  putInto(json, optionsOf(run));
  return json;
}

Json movementValues(const MovementOptions& given) {
  MovementOptions movement = given;
  Json json;
  putInto(json, movementOptionsOf(movement));
  return json.at("movement");
}

std::string optionsListed() {
  RunOptions run;
  Json all = Json::array();
  for (const Option& option : optionsOf(run)) {
    if (option.giver != Giver::Library) all.push_back(listed(option));
  }
  return all.dump(2) + "\n";
}

}  // namespace tank_datum
