#include "results/commit.h"

#include <filesystem>
#include <iostream>
#include <sstream>

#include "core/printable.h"
#include "core/refusal.h"
#include "results/file_calls.h"
#include "tank_datum/core/error.h"

namespace tank_datum::results {
namespace fs = std::filesystem;

void commit(Staging& staging, const std::string& folder, const Journal& journal, const std::string& prefix) {
  try {
    apply(folder, journal);
    declareDone(folder);
  } catch (const Error&) {
    try {
      for (const std::string& line : undo(folder, journal)) sayLines(prefix, line);
    } catch (const Error&) {
      staging.abandon();
      sayLines(prefix, folder + " could not be put right: a journal stays in it, for the next run to do so");
    }
    throw;
  }
  try {
    sync(staging.path());
    throwAway(folder, journal);
    staging.remove();
  } catch (const Error&) {
    staging.abandon();  // the results are in place; the next run removes what is left
  }
}

void sayLines(const std::string& prefix, const std::string& lines) {
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) std::cerr << prefix << ": " << printable(line) << "\n";
}

std::vector<std::string> syncedFiles(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code failed;
  for (fs::recursive_directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string path = at->path().string();
    sync(path);
    if (kindOf(path) == Kind::File) files.push_back(fs::path(path).lexically_relative(folder).string());
  }
  if (failed) throw refusedBySystem("report", folder, folder, failed.value(), "a folder that can be listed");
  sync(folder);
  return files;
}

}  // namespace tank_datum::results
