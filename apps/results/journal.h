#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tank_datum::results {

/// The folder in which one commit at a time is under way. A run renames its staging folder to this name.
constexpr const char* kCommitFolder = ".tank_datum-commit";

/// What a commit moves, written down before it moves anything. All paths are relative to the result folder.
///
/// As long as `journal.json` stands in the commit folder the commit counts as not done, and undo() leads back to the
/// earlier result from wherever it stopped. Renaming it to `done.json` is the moment from which the new result counts;
/// what then is left to do is to throw away.
struct Journal {
  std::vector<std::string> folders;                            ///< made for the new files, "tank_1"
  std::vector<std::pair<std::string, std::string>> displaced;  ///< what stands in the way, and where it goes
  std::vector<std::string> added;                              ///< new files
  std::vector<std::string> emptied;  ///< folders of an earlier run, removed if nothing is left

  std::string text() const;
  /// @throws Error (File) naming the path when the text is no journal
  static Journal parsed(const std::string& text, const std::string& path);
};

/// Where an own file of an earlier run waits to be thrown away, and where a new one waits for its place.
std::string oldPlace(const std::string& path);
std::string newPlace(const std::string& path);

/// Writes the journal, moves everything, and waits for the disk. After an Error undo() is to be called.
void apply(const std::string& folder, const Journal& journal);

/// The moment from which the new result counts.
void declareDone(const std::string& folder);

/// Leads back to the earlier result; may be called again after it was stopped anywhere.
/// @return lines about what could not go back to its name, since a new file of somebody else has it
std::vector<std::string> undo(const std::string& folder, const Journal& journal);

/// Throws away what the new result replaces.
void throwAway(const std::string& folder, const Journal& journal);

}  // namespace tank_datum::results
