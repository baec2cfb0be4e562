#include "results/output_guard.h"

#include <filesystem>

#include "results/manifest.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

/// By device and inode; of what is not there, by the path with every link in it resolved.
bool areSame(const std::string& a, const std::string& b) {
  std::error_code unknown;
  if (fs::exists(a, unknown) && fs::exists(b, unknown)) return fs::equivalent(a, b, unknown);
  const fs::path one = fs::weakly_canonical(fs::absolute(a, unknown), unknown);
  return !one.empty() && one == fs::weakly_canonical(fs::absolute(b, unknown), unknown);
}

void addNames(std::vector<NamedPath>& all, const std::string& folder, const std::string& program) {
  for (const std::string& name : results::contractNames(program)) all.push_back({"--output", folder + "/" + name});
}

}  // namespace

std::vector<NamedPath> outputsOf(const std::string& folder, const std::string& program) {
  std::vector<NamedPath> all = {{"--output", folder}, {"--output", folder + "/" + results::kManifest}};
  addNames(all, folder, program);
  std::error_code unknown;
  for (fs::directory_iterator at(folder, unknown), end; !unknown && at != end; at.increment(unknown)) {
    const std::string path = at->path().string();
    std::error_code no_folder;
    if (!results::isTankFolder(at->path().filename().string()) || !fs::is_directory(path, no_folder)) continue;
    all.push_back({"--output", path});
    addNames(all, path, program);
  }
  return all;
}

std::vector<NamedPath> inputsOf(const std::string& name, const std::string& path) {
  std::vector<NamedPath> all = {{name, path}};
  std::error_code unknown;
  const fs::path given(path);
  const bool folder = fs::is_directory(given, unknown);
  if (!folder && given.filename() != "datum.json") return all;
  const fs::path results = folder ? given : given.parent_path();
  for (const std::string& file : results::contractNames(results::kDatumProgram)) {
    all.push_back({name, (results / file).string()});
  }
  return all;
}

void requireApart(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs) {
  for (const NamedPath& output : outputs) {
    for (const NamedPath& input : inputs) {
      if (output.path.empty() || input.path.empty() || !areSame(output.path, input.path)) continue;
      throw Error(Error::Kind::Option, "command line", output.name, output.path,
                  "a place outside of the inputs; this is the " + input.name + " " + input.path);
    }
  }
}

}  // namespace tank_datum
