#include "results/plan.h"

#include <filesystem>
#include <set>

#include "io/sha256.h"
#include "results/file_calls.h"
#include "results/manifest.h"

namespace tank_datum::results {
namespace {

namespace fs = std::filesystem;

std::string parentOf(const std::string& path) { return fs::path(path).parent_path().string(); }

/// Builds a plan; its members are the steps.
class Planner {
 public:
  Planner(const std::string& folder, const std::string& program, const std::map<std::string, std::string>& added)
      : folder_(folder), program_(program), added_(added) {
    const std::optional<Manifest> manifest = Manifest::of(folder);
    own_manifest_ = manifest.has_value();
    if (manifest) {
      before_ = *manifest;
    } else {
      findUnlisted();
    }
  }

  Plan plan() {
    for (const auto& [path, hash] : added_) makeWay(parentOf(path));
    for (const auto& [path, entry] : before_.files) {
      if (entry.program == program_ || added_.count(path) > 0) displace(path);
    }
    for (const auto& [path, hash] : added_) {
      if (before_.files.count(path) == 0) displace(path);
    }
    if (exists(folder_ + "/" + kManifest)) own_manifest_ ? giveWay(kManifest) : keep(kManifest);
    for (const auto& [path, hash] : added_) plan_.journal.added.push_back(path);
    plan_.journal.added.push_back(kManifest);
    findEmptied();
    plan_.manifest = after().text();
    return std::move(plan_);
  }

 private:
  /// What a run before there were manifests left: here, and where new files go.
  void findUnlisted() {
    std::set<std::string> places = {""};
    for (const auto& [path, hash] : added_) places.insert(parentOf(path));
    for (const std::string& place : places) {
      const std::string prefix = place.empty() ? "" : place + "/";
      if (!inRealFolders(folder_, prefix + "x") || !holdsUnlistedResult(folder_ + "/" + place, program_)) continue;
      for (const std::string& name : contractNames(program_)) {
        if (kindOf(folder_ + "/" + prefix + name) == Kind::File) before_.files[prefix + name] = {"", program_};
      }
    }
  }

  /// A folder for new files, where a file or a link may have its name.
  void makeWay(const std::string& place) {
    if (place.empty() || !made_.insert(place).second || kindOf(folder_ + "/" + place) == Kind::Folder) return;
    if (exists(folder_ + "/" + place)) keep(place);
    plan_.journal.folders.push_back(place);
  }

  void displace(const std::string& path) {
    const std::string place = folder_ + "/" + path;
    if (!inRealFolders(folder_, path) || !exists(place)) return;
    isOwn(path) ? giveWay(path) : keep(path);
  }

  bool isOwn(const std::string& path) const {
    const std::string place = folder_ + "/" + path;
    if (kindOf(place) != Kind::File) return false;
    const auto before = before_.files.find(path);
    if (before != before_.files.end() && before->second.program == program_ && before->second.sha256.empty()) {
      return true;  // of a run before there were manifests
    }
    const std::string hash = sha256OfFile(place);
    if (before != before_.files.end() && before->second.program == program_ && hash == before->second.sha256) {
      return true;
    }
    const auto same = added_.find(path);
    return same != added_.end() && hash == same->second;
  }

  void giveWay(const std::string& path) { plan_.journal.displaced.emplace_back(path, oldPlace(path)); }

  void keep(const std::string& path) {
    const fs::path place = fs::path(folder_) / path;
    const std::string name = fs::path(keptName(place.string())).filename().string();
    plan_.journal.displaced.emplace_back(path, (fs::path(path).parent_path() / name).string());
    plan_.said.push_back(place.string() + whyKept(path) + ": kept as " + (place.parent_path() / name).string());
  }

  std::string whyKept(const std::string& path) const {
    const auto before = before_.files.find(path);
    if (before == before_.files.end()) return " is not of this program";
    const auto& [hash, program] = before->second;
    const std::string place = folder_ + "/" + path;
    const bool is_of_other = program != program_ && kindOf(place) == Kind::File && sha256OfFile(place) == hash;
    return is_of_other ? " is of " + program : " was changed since it was written";
  }

  void findEmptied() {
    std::set<std::string> places;
    for (const auto& [path, entry] : before_.files) {
      const std::string place = parentOf(path);
      if (entry.program == program_ && !place.empty() && made_.count(place) == 0) places.insert(place);
    }
    plan_.journal.emptied.assign(places.begin(), places.end());
  }

  Manifest after() const {
    Manifest manifest;
    for (const auto& [path, entry] : before_.files) {
      if (entry.program != program_) manifest.files[path] = entry;
    }
    for (const auto& [path, hash] : added_) manifest.files[path] = {hash, program_};
    return manifest;
  }

  const std::string& folder_;
  const std::string& program_;
  const std::map<std::string, std::string>& added_;
  Manifest before_;
  bool own_manifest_ = false;
  std::set<std::string> made_;
  Plan plan_;
};

}  // namespace

Plan planOf(const std::string& folder, const std::string& program, const std::map<std::string, std::string>& added) {
  return Planner(folder, program, added).plan();
}

}  // namespace tank_datum::results
