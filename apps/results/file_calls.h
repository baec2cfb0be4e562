#pragma once

#include <string>

namespace tank_datum::results {

/// Calls to the file system, each a step that may fail. A failure is an Error (File) that names the path and the
/// system's reason. None but sync() follows a symbolic link at the end of a path.

/// What stands under a name.
enum class Kind { Nothing, File, Folder, Other };  ///< Other: a symbolic link, a device, a pipe
Kind kindOf(const std::string& path);

inline bool exists(const std::string& path) { return kindOf(path) != Kind::Nothing; }

/// Makes a folder whose parent exists.
/// @return false when it was there before
bool makeFolder(const std::string& path);

/// Renames; both names are on one file system. Where `to` exists it is refused, never replaced.
void move(const std::string& from, const std::string& to);

/// Removes a file if it is there.
void removeFile(const std::string& path);

/// Removes a folder with all that is in it, links themselves and not what they lead to.
void removeTree(const std::string& path);

/// Removes a folder if it is there and empty.
/// @return whether it is gone
bool removeEmptyFolder(const std::string& path) noexcept;

/// Writes a new file and waits until the disk has it.
void writeSynced(const std::string& path, const std::string& content);

/// Waits until the disk has the file's bytes, or the folder's names.
void sync(const std::string& path);

/// The content of a regular file; an empty text when there is none.
std::string contentOf(const std::string& path);

/// Whether every folder on the way from `folder` to `folder/path` is a folder and no link.
bool inRealFolders(const std::string& folder, const std::string& path);

/// A free name beside path that says that something of somebody else was kept: report.kept.html, report.kept-2.html.
std::string keptName(const std::string& path);

}  // namespace tank_datum::results
