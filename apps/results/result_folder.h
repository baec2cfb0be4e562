#pragma once

#include <memory>
#include <string>
#include <vector>

#include "results/staging.h"
#include "results/stop_signals.h"

namespace tank_datum {

/// A folder that receives a set of result files whole or not at all, and in which everything else stays.
///
/// Files are written into a hidden folder inside it and moved by commit() into the place of the files of the program's
/// earlier run, which manifest.json names. Without commit() everything stays as it was. A process that is killed while
/// it moves leaves a journal, by which the next run or reader puts the folder right.
class ResultFolder {
 public:
  /// Makes the folder if it is missing, and puts right what a killed run left in it.
  /// @param program  who writes, as in the manifest; it begins the lines on stderr too
  /// @throws Error (File) when it cannot be made, listed or written to
  ResultFolder(const std::string& path, std::string program);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Where to write the files of a part of the results: `name` is a folder such as "tank_1", or "" for the folder
  /// itself.
  /// @throws Error (File) when it cannot be made
  std::string stage(const std::string& name) const;

  /// Puts the new files, and a manifest of them, in the place of the earlier ones. What somebody else has put there
  /// under the same name, or changed, is kept under another name, with a line on stderr.
  /// @throws Error (File)  everything is as it was
  void commit();

 private:
  std::string path_, program_;
  std::vector<std::string> made_;  ///< folders that were missing, the outermost first
  std::unique_ptr<results::Staging> staging_;
  std::unique_ptr<results::OnStop> on_stop_;
};

/// For the end of a line about a run that failed: "; the results of this run are in DIR" where it had written them,
/// else "; DIR holds the results of an earlier run, unchanged", or nothing.
std::string resultsLeft(const std::string& folder, const std::string& program, bool written);

/// Puts right what a killed run left in a folder that is about to be read, with a line on stderr.
/// @param path  a folder of results, or a file in one
/// @throws Error (File) when its results are incomplete and this cannot be changed
void settleToRead(const std::string& path, const std::string& program);

}  // namespace tank_datum
