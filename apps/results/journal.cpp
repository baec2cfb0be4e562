#include "results/journal.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "results/file_calls.h"
#include "tank_datum/core/error.h"

namespace tank_datum::results {
namespace {

using Json = nlohmann::ordered_json;

std::string commitFile(const std::string& folder, const char* name) {
  return folder + "/" + kCommitFolder + "/" + name;
}

/// The folders that a journal changes, those that are there.
std::set<std::string> touched(const std::string& folder, const Journal& journal) {
  std::set<std::string> names = {folder};
  const auto add = [&](const std::string& path) {
    const std::string parent = std::filesystem::path(folder + "/" + path).parent_path().string();
    if (kindOf(parent) == Kind::Folder) names.insert(parent);
  };
  for (const auto& [from, to] : journal.displaced) add(from), add(to);
  for (const std::string& path : journal.added) add(path);
  return names;
}

void syncTouched(const std::string& folder, const Journal& journal) {
  for (const std::string& name : touched(folder, journal)) sync(name);
}

}  // namespace

std::string oldPlace(const std::string& path) { return std::string(kCommitFolder) + "/old/" + path; }
std::string newPlace(const std::string& path) { return std::string(kCommitFolder) + "/new/" + path; }

std::string Journal::text() const {
  Json moves = Json::array();
  for (const auto& [from, to] : displaced) moves.push_back({from, to});
  return Json{{"schema", 1}, {"folders", folders}, {"displaced", moves}, {"added", added}, {"emptied", emptied}}.dump(
      1, ' ', false, Json::error_handler_t::replace);
}

Journal Journal::parsed(const std::string& text, const std::string& path) {
  try {
    const Json json = Json::parse(text);
    Journal journal;
    json.at("folders").get_to(journal.folders);
    json.at("displaced").get_to(journal.displaced);
    json.at("added").get_to(journal.added);
    json.at("emptied").get_to(journal.emptied);
    return journal;
  } catch (const Json::exception&) {
    throw Error(Error::Kind::File, "report", path, "no journal", "the journal of a run that was stopped");
  }
}

void apply(const std::string& folder, const Journal& journal) {
  const std::string part = commitFile(folder, "journal.json.part");
  for (const auto& [from, to] : journal.displaced) {  // the places of old files
    if (to.rfind(kCommitFolder, 0) != 0) continue;
    std::string way = folder;
    for (const auto& name : std::filesystem::path(to).parent_path()) makeFolder(way += "/" + name.string());
  }
  writeSynced(part, journal.text());
  move(part, commitFile(folder, "journal.json"));
  sync(folder + "/" + kCommitFolder);
  for (const auto& [from, to] : journal.displaced) move(folder + "/" + from, folder + "/" + to);
  for (const std::string& name : journal.folders) makeFolder(folder + "/" + name);
  for (const std::string& path : journal.added) move(folder + "/" + newPlace(path), folder + "/" + path);
  syncTouched(folder, journal);
}

void declareDone(const std::string& folder) {
  move(commitFile(folder, "journal.json"), commitFile(folder, "done.json"));
}

std::vector<std::string> undo(const std::string& folder, const Journal& journal) {
  std::vector<std::string> said;
  std::set<std::string> untouched;  // a new file cannot have the place of what has not been moved away
  for (const auto& [from, to] : journal.displaced) {
    if (!exists(folder + "/" + to)) untouched.insert(from);
  }
  for (auto path = journal.added.rbegin(); path != journal.added.rend(); ++path) {
    const std::string place = folder + "/" + *path, waiting = folder + "/" + newPlace(*path);
    if (!exists(waiting) && exists(place) && untouched.count(*path) == 0) move(place, waiting);
  }
  for (auto name = journal.folders.rbegin(); name != journal.folders.rend(); ++name) {
    removeEmptyFolder(folder + "/" + *name);
  }
  for (auto moved = journal.displaced.rbegin(); moved != journal.displaced.rend(); ++moved) {
    const std::string place = folder + "/" + moved->first, away = folder + "/" + moved->second;
    if (!exists(away)) continue;
    if (exists(place)) {  // made after the run was stopped
      const std::string kept = keptName(place);
      move(place, kept);
      said.push_back(place + " is a result of an earlier run again; what had its name is kept as " + kept);
    }
    move(away, place);
  }
  syncTouched(folder, journal);
  removeFile(commitFile(folder, "journal.json"));
  return said;
}

void throwAway(const std::string& folder, const Journal& journal) {
  removeTree(folder + "/" + kCommitFolder + "/old");
  for (auto name = journal.emptied.rbegin(); name != journal.emptied.rend(); ++name) {
    if (kindOf(folder + "/" + *name) == Kind::Folder) removeEmptyFolder(folder + "/" + *name);
  }
}

}  // namespace tank_datum::results
