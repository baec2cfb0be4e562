#include "result_folder.h"

#include <unistd.h>

#include <filesystem>

#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResults[] = {"datum.json",       "stations.csv",    "shell.csv",
                                    "datum_points.pcd", "datum_curve.pcd", "report.html"};

Error failure(const fs::path& path, const std::error_code& code, const std::string& expected) {
  return Error(Error::Kind::File, "report", path.string(), code.message(), expected);
}

void move(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  fs::rename(from, to, code);
  if (code) throw failure(to, code, "a folder that can be written to");
}

}  // namespace

std::vector<std::string> ResultFolder::resultNames() { return {std::begin(kResults), std::end(kResults)}; }

ResultFolder::ResultFolder(std::string path, std::vector<std::string> names)
    : path_(std::move(path)), names_(std::move(names)) {
  std::error_code code;
  made_ = fs::create_directories(path_, code);
  if (code) throw failure(path_, code, "a folder that can be made");
  staging_ = path_ + "/.tank_datum-" + std::to_string(getpid());
  fs::remove_all(staging_, code);
  if (!fs::create_directory(staging_, code) || code) throw failure(path_, code, "a folder that can be written to");
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  if (committed_) return;
  for (const std::string& name : earlier()) {
    const fs::path to = fs::path(path_) / "previous" / name;
    fs::create_directories(to.parent_path(), ignored);
    fs::rename(fs::path(path_) / name, to, ignored);
  }
  if (made_) fs::remove(path_, ignored);
}

std::string ResultFolder::stage(const std::string& name) const {
  const std::string folder = name.empty() ? staging_ : staging_ + "/" + name;
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) throw failure(folder, code, "a folder that can be made");
  return folder;
}

std::vector<std::string> ResultFolder::earlier() const {
  std::vector<std::string> folders = {""}, names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(path_, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("tank_", 0) == 0 && entry.is_directory(ignored)) folders.push_back(name + "/");
  }
  for (const std::string& folder : folders) {
    for (const std::string& result : names_) {
      if (fs::exists(path_ + "/" + folder + result, ignored)) names.push_back(folder + result);
    }
  }
  return names;
}

void ResultFolder::commit() {
  std::error_code code;
  for (const std::string& name : earlier()) fs::remove(path_ + "/" + name, code);
  for (const auto& entry : fs::directory_iterator(path_)) {  // folders of tanks that are found no more
    if (entry.path().filename().string().rfind("tank_", 0) == 0) fs::remove(entry.path(), code);
  }
  for (const auto& entry : fs::recursive_directory_iterator(staging_)) {
    if (entry.is_regular_file()) move(entry.path(), fs::path(path_) / fs::relative(entry.path(), staging_));
  }
  committed_ = true;
}

}  // namespace tank_datum
