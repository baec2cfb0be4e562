#include "scene_file.h"

#include <cmath>
#include <initializer_list>
#include <set>

#include "io/whole_file.h"
#include "option_fields.h"
#include "tank_datum/core/error.h"

namespace tank_datum::synth {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& name, const Json& value, const std::string& expected) {
  throw Error(Error::Kind::Option, "scene", name, value.dump(), expected);
}

/// Fills options from one JSON object and remembers which keys it knew.
class Reader {
 public:
  Reader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
    if (!json.is_object()) refuse(path_.empty() ? "scene" : path_, json, "an object");
  }

  void number(const char* name, double& value, Limit = {}) {
    if (const Json* node = find(name)) value = asNumber(name, *node);
  }
  void angle(const char* name, double& value, Limit = {}) {
    if (const Json* node = find(name)) value = radians(asNumber(name, *node));
  }
  void arcsec(const char* name, double& value, Limit = {}) {
    if (const Json* node = find(name)) value = radians(asNumber(name, *node) / 3600.0);
  }
  void optional(const char* name, double& value) {
    const Json* node = find(name);
    if (node != nullptr && !node->is_null()) value = asNumber(name, *node);
  }
  void integer(const char* name, int& value, Limit = {}) {
    const Json* node = find(name);
    if (node == nullptr) return;
    if (!node->is_number_integer()) refuse(path_ + name, *node, "a whole number");
    const auto wide = node->get<std::int64_t>();
    if (wide < -1000000000 || wide > 1000000000) refuse(path_ + name, *node, "a smaller whole number");
    value = static_cast<int>(wide);
  }
  void unsignedInteger(const char* name, std::uint64_t& value) {
    const Json* node = find(name);
    if (node == nullptr) return;
    const bool good = node->is_number_unsigned() || (node->is_number_integer() && node->get<std::int64_t>() >= 0);
    if (!good) refuse(path_ + name, *node, "a whole number >= 0");
    value = node->get<std::uint64_t>();
  }
  void flag(const char* name, bool& value) {
    const Json* node = find(name);
    if (node == nullptr) return;
    if (!node->is_boolean()) refuse(path_ + name, *node, "true or false");
    value = node->get<bool>();
  }
  void choice(const char* name, std::string& value, std::initializer_list<const char*>) {
    const Json* node = find(name);
    if (node == nullptr) return;
    if (!node->is_string()) refuse(path_ + name, *node, "a word");
    value = node->get<std::string>();
  }
  void triple(const char* name, std::array<double, 3>& values) {
    const Json* node = find(name);
    if (node == nullptr) return;
    if (!node->is_array() || node->size() != values.size()) refuse(path_ + name, *node, "three numbers");
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = asNumber(name, (*node)[i]);
  }
  template <class T>
  void group(const std::string& name, T& options) {
    const Json* node = find(name);
    if (node == nullptr) return;
    Reader inner(*node, path_ + name + ".");
    fields(inner, options);
    inner.refuseUnknown();
  }
  template <class T>
  void list(const std::string& name, std::vector<T>& options) {
    const Json* node = find(name);
    if (node == nullptr) return;
    if (!node->is_array()) refuse(path_ + name, *node, "a list");
    options.assign(node->size(), T{});
    for (std::size_t i = 0; i < node->size(); ++i) {
      Reader inner((*node)[i], path_ + name + "[" + std::to_string(i) + "].");
      fields(inner, options[i]);
      inner.refuseUnknown();
    }
  }
  void refuseUnknown() const {
    for (const auto& [key, value] : json_.items())
      if (key != "comment" && known_.count(key) == 0) refuse(path_ + key, value, "no such key");
  }

 private:
  const Json* find(const std::string& name) {
    known_.insert(name);
    const auto at = json_.find(name);
    return at == json_.end() ? nullptr : &*at;
  }
  double asNumber(const std::string& name, const Json& node) const {
    if (!node.is_number()) refuse(path_ + name, node, "a number");
    return node.get<double>();
  }

  const Json& json_;
  std::string path_;
  std::set<std::string> known_;
};

/// Writes options into one JSON object.
class Writer {
 public:
  Json json = Json::object();

  void number(const char* name, double value, Limit = {}) { json[name] = value; }
  void angle(const char* name, double value, Limit = {}) {
    json[name] = std::round(degrees(value) * 1e10) / 1e10;  // 60, not 59.99999999999999
  }
  void arcsec(const char* name, double value, Limit = {}) {
    json[name] = std::round(3600.0 * degrees(value) * 1e10) / 1e10;
  }
  void optional(const char* name, double value) { json[name] = std::isnan(value) ? Json() : Json(value); }
  void integer(const char* name, int value, Limit = {}) { json[name] = value; }
  void unsignedInteger(const char* name, std::uint64_t value) { json[name] = value; }
  void flag(const char* name, bool value) { json[name] = value; }
  void choice(const char* name, const std::string& value, std::initializer_list<const char*>) { json[name] = value; }
  void triple(const char* name, const std::array<double, 3>& values) { json[name] = values; }
  template <class T>
  void group(const std::string& name, T& options) {
    json[name] = written(options);
  }
  template <class T>
  void list(const std::string& name, std::vector<T>& options) {
    json[name] = Json::array();
    for (T& one : options) json[name].push_back(written(one));
  }

 private:
  template <class T>
  static Json written(T& options) {
    Writer inner;
    fields(inner, options);
    return inner.json;
  }
};

}  // namespace

SceneOptions sceneFromJson(const Json& json) {
  SceneOptions options;
  Reader reader(json, "");
  fields(reader, options);
  reader.refuseUnknown();
  return options;
}

Json toJson(const SceneOptions& options) {
  SceneOptions copy = options;  // visitors take what they visit by reference
  Writer writer;
  fields(writer, copy);
  return writer.json;
}

Json readJson(const std::string& path) {
  constexpr int kDeepest = 16;  // lists and groups in each other; a scene has four
  const auto look = [&path](int depth, Json::parse_event_t, const Json&) {
    if (depth <= kDeepest) return true;
    throw Error(Error::Kind::File, "scene", {"scene file", path, "JSON that is not nested deeper than a scene", path});
  };
  Json json = Json::parse(wholeFile(path, "scene"), look, false);
  if (json.is_discarded()) throw Error(Error::Kind::File, "scene", {"scene file", path, "JSON", path});
  return json;
}

SceneOptions readScene(const std::string& path) { return sceneFromJson(readJson(path)); }

}  // namespace tank_datum::synth
