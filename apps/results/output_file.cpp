#include "results/output_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/refusal.h"
#include "results/commit.h"
#include "results/file_calls.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;
using namespace results;

/// Where a file will be, its links followed; empty when that is a device or a pipe.
fs::path targetOf(const std::string& path) {
  if (path == "-") {  // elsewhere standard output
    throw Error(Error::Kind::Option, "command line", "an output file", "-", "its name, or ./- for one of that name");
  }
  std::error_code unknown;
  const fs::file_status status = fs::status(path, unknown);
  if (fs::is_directory(status)) throw Error(Error::Kind::File, "report", path, "a folder", "the name of a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  if (!fs::is_symlink(fs::symlink_status(path, unknown))) return path;
  const fs::path target = fs::weakly_canonical(path, unknown);
  return target.empty() ? fs::path(path) : target;
}

}  // namespace

IsOwn isJsonWith(std::vector<std::string> keys) {
  return [keys = std::move(keys)](const std::string& path) {
    const auto json = nlohmann::json::parse(contentOf(path), nullptr, false);
    for (const std::string& key : keys) {
      if (!json.is_object() || !json.contains(key)) return false;
    }
    return true;
  };
}

IsOwn isFileWith(std::string beginning, std::string mark) {
  return [beginning = std::move(beginning), mark = std::move(mark)](const std::string& path) {
    constexpr std::size_t kNear = 1024;
    std::string head(kNear, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(kNear));
    if (!in && !in.eof()) throw Error(Error::Kind::File, "report", path, "not read", "a file that can be read");
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head.rfind(beginning, 0) == 0 && head.find(mark) != std::string::npos;
  };
}

IsOwn isReportPage() { return isFileWith("<!DOCTYPE html>", "<title>tank_datum</title>"); }

OutputFile::OutputFile(const std::string& path, IsOwn own, std::string program)
    : path_(path), program_(std::move(program)), own_(std::move(own)) {
  const fs::path target = targetOf(path);
  if (target.empty()) return;
  folder_ = target.has_parent_path() ? target.parent_path().string() : ".";
  name_ = target.filename().string();
  const NoStop hold;
  try {
    removeStale(folder_);
    sayLines(program_, settle(folder_));
    staging_ = std::make_unique<Staging>(folder_);
  } catch (const Error& error) {
    throw reworded(error, "report", path, path, "a file in a folder that can be written to");
  }
  on_stop_ = std::make_unique<OnStop>([this] { staging_->remove(); });
}

OutputFile::~OutputFile() {
  const NoStop hold;
  on_stop_.reset();
  staging_.reset();
}

std::string OutputFile::place() const { return staging_ ? staging_->newFiles() + "/" + name_ : path_; }

void OutputFile::write(const std::string& content) const {
  errno = 0;
  std::ofstream out(place(), std::ios::binary);
  out << content;
  out.close();
  if (out) return;
  throw refusedBySystem("report", path_, path_, errno, "a writable file, and room for it");
}

void OutputFile::commit() { commitTogether({this}); }

void commitTogether(const std::vector<OutputFile*>& files) {
  const NoStop hold;
  std::map<std::string, std::vector<OutputFile*>> by_folder;
  for (OutputFile* file : files) {
    if (file->staging_) by_folder[file->folder_].push_back(file);
  }
  for (const auto& [folder, together] : by_folder) OutputFile::commitIn(folder, together);
}

void OutputFile::commitIn(const std::string& folder, const std::vector<OutputFile*>& files) {
  Staging& staging = *files.front()->staging_;
  const std::string& program = files.front()->program_;
  for (const OutputFile* file : files) {
    if (file != files.front()) move(file->place(), staging.newFiles() + "/" + file->name_);
  }
  Journal journal;
  journal.added = syncedFiles(staging.newFiles());
  sayLines(program, staging.enterCommit());
  std::string said;
  for (const OutputFile* file : files) {
    const std::string target = folder + "/" + file->name_;
    if (!exists(target)) continue;
    const bool own = file->own_(target);
    const std::string kept = own ? oldPlace(file->name_) : fs::path(keptName(target)).filename().string();
    journal.displaced.emplace_back(file->name_, kept);
    if (!own) said += target + " is not of this program: kept as " + folder + "/" + kept + "\n";
  }
  results::commit(staging, folder, journal, program);
  sayLines(program, said);
}

}  // namespace tank_datum
