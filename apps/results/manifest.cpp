#include "results/manifest.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "results/file_calls.h"

namespace tank_datum::results {
namespace {

using Json = nlohmann::ordered_json;

/// A path that stays in its folder, and out of the hidden ones.
bool staysBelow(const std::string& path) {
  const std::filesystem::path parts(path);
  if (path.empty() || parts.is_absolute() || path.rfind(".tank_datum-", 0) == 0) return false;
  return std::none_of(parts.begin(), parts.end(), [](const auto& part) { return part == ".." || part == "."; });
}

/// What tells a program's main file from one of somebody else.
bool hasKeys(const std::string& path, const std::vector<const char*>& keys) {
  const Json json = Json::parse(contentOf(path), nullptr, false);
  return json.is_object() &&
         std::all_of(keys.begin(), keys.end(), [&json](const char* key) { return json.contains(key); });
}

}  // namespace

const std::vector<std::string>& contractNames(const std::string& program) {
  static const std::vector<std::string> datum = {"datum.json",       "stations.csv",    "shell.csv",
                                                 "datum_points.pcd", "datum_curve.pcd", "report.html"};
  static const std::vector<std::string> movement = {"movement.json", "movement.csv", "report.html"};
  return program == kCompareProgram ? movement : datum;
}

bool isTankFolder(const std::string& name) {
  const std::string prefix = "tank_";
  return name.size() > prefix.size() && name.rfind(prefix, 0) == 0 && name[prefix.size()] != '0' &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

std::string Manifest::text() const {
  Json list = Json::array();
  for (const auto& [path, entry] : files) {
    list.push_back({{"path", path}, {"sha256", entry.sha256}, {"program", entry.program}});
  }
  return Json{{"schema", 1}, {"about", "files of tank_datum, which its next run replaces; no others"}, {"files", list}}
             .dump(1) +
         "\n";
}

std::optional<Manifest> Manifest::of(const std::string& folder) {
  const Json json = Json::parse(contentOf(folder + "/" + kManifest), nullptr, false);
  if (!json.is_object() || json.value("schema", Json()) != 1 || !json.contains("files")) return std::nullopt;
  Manifest manifest;
  try {
    for (const Json& file : json.at("files").get_ref<const Json::array_t&>()) {
      const auto path = file.at("path").get<std::string>();
      if (!staysBelow(path) || path == kManifest) return std::nullopt;
      manifest.files[path] = {file.at("sha256").get<std::string>(), file.at("program").get<std::string>()};
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return manifest;
}

bool holdsUnlistedResult(const std::string& folder, const std::string& program) {
  if (program == kCompareProgram) return hasKeys(folder + "/movement.json", {"schema", "version", "surveys", "trend"});
  return hasKeys(folder + "/datum.json", {"schema", "version", "input", "options", "status"});
}

bool holdsResult(const std::string& folder, const std::string& program) {
  const std::optional<Manifest> manifest = Manifest::of(folder);
  if (!manifest) return holdsUnlistedResult(folder, program);
  return std::any_of(manifest->files.begin(), manifest->files.end(), [&](const auto& file) {
    return file.second.program == program && kindOf(folder + "/" + file.first) == Kind::File;
  });
}

}  // namespace tank_datum::results
