#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tank_datum::results {

constexpr const char* kManifest = "manifest.json";

/// The programs that fill result folders, by the name in the manifest.
constexpr const char* kDatumProgram = "tank_datum";
constexpr const char* kCompareProgram = "tank_datum_compare";

/// The names of the files that a program writes into a result folder, or into a tank_N of it.
const std::vector<std::string>& contractNames(const std::string& program);

/// Whether a name is that of a tank's folder: tank_1, tank_2, ...
bool isTankFolder(const std::string& name);

/// manifest.json: the project's own files in a result folder, with what they held when they were written.
struct Manifest {
  struct Entry {
    std::string sha256, program;
  };
  std::map<std::string, Entry> files;  ///< by path relative to the folder

  /// The same files give the same text.
  std::string text() const;
  /// Nothing when there is no manifest.json, or one of somebody else.
  static std::optional<Manifest> of(const std::string& folder);
};

/// Whether a folder, or a tank_N of it, holds a result that a program wrote before there were manifests.
bool holdsUnlistedResult(const std::string& folder, const std::string& program);

/// Whether a folder holds a result of an earlier run of a program.
bool holdsResult(const std::string& folder, const std::string& program);

}  // namespace tank_datum::results
