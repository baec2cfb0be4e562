#include "results/result_folder.h"

#include <filesystem>
#include <map>

#include "core/refusal.h"
#include "io/sha256.h"
#include "results/commit.h"
#include "results/file_calls.h"
#include "results/manifest.h"
#include "results/plan.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;
using namespace results;

/// Removes folders if they are empty, the innermost first.
void removeAll(const std::vector<std::string>& folders) {
  for (auto name = folders.rbegin(); name != folders.rend(); ++name) removeEmptyFolder(*name);
}

/// The folders on the way to path that are missing, made; the outermost first.
std::vector<std::string> makeAll(const std::string& path) {
  std::vector<std::string> missing, made;
  std::error_code unknown;
  for (fs::path way = path; !way.empty() && !fs::exists(way, unknown); way = way.parent_path()) {
    missing.insert(missing.begin(), way.string());
  }
  try {
    for (const std::string& name : missing) {
      if (makeFolder(name)) made.push_back(name);
    }
  } catch (const Error& error) {
    removeAll(made);
    throw reworded(error, "report", path, path, "a folder that can be made");
  }
  return made;
}

}  // namespace

ResultFolder::ResultFolder(const std::string& path, std::string program) : path_(path), program_(std::move(program)) {
  while (path_.size() > 1 && path_.back() == '/') path_.pop_back();
  std::error_code unknown;
  if (fs::exists(path_, unknown) && !fs::is_directory(path_, unknown)) {
    throw Error(Error::Kind::File, "report", path_, "no folder", "a folder, or the name of a new one");
  }
  const NoStop hold;
  made_ = makeAll(path_);
  try {
    removeStale(path_);
    sayLines(program_, settle(path_));
    staging_ = std::make_unique<Staging>(path_);
  } catch (const Error&) {
    removeAll(made_);
    throw;
  }
  on_stop_ = std::make_unique<OnStop>([this] {
    staging_->remove();
    removeAll(made_);
  });
}

ResultFolder::~ResultFolder() {
  const NoStop hold;
  on_stop_.reset();
  staging_.reset();
  removeAll(made_);  // no result came
}

std::string ResultFolder::stage(const std::string& name) const {
  if (name.empty()) return staging_->newFiles();
  const std::string folder = staging_->newFiles() + "/" + name;
  makeFolder(folder);
  return folder;
}

void ResultFolder::commit() {
  const NoStop hold;
  std::map<std::string, std::string> hashes;
  for (const std::string& path : syncedFiles(staging_->newFiles())) {
    hashes[path] = sha256OfFile(staging_->newFiles() + "/" + path);
  }
  sayLines(program_, staging_->enterCommit());
  const Plan plan = planOf(path_, program_, hashes);
  writeSynced(staging_->newFiles() + "/" + kManifest, plan.manifest);
  results::commit(*staging_, path_, plan.journal, program_);
  made_.clear();
  for (const std::string& line : plan.said) sayLines(program_, line);
}

std::string resultsLeft(const std::string& folder, const std::string& program, bool written) {
  if (written) return "; the results of this run are in " + folder;
  try {
    return holdsResult(folder, program) ? "; " + folder + " holds the results of an earlier run, unchanged" : "";
  } catch (const Error&) {
    return "";
  }
}

void settleToRead(const std::string& path, const std::string& program) {
  std::error_code unknown;
  const fs::path place(path);
  const fs::path folder = fs::is_directory(place, unknown) ? place : place.parent_path();
  sayLines(program, results::settleToRead(folder.empty() ? "." : folder.string()));
}

}  // namespace tank_datum
