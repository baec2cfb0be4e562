#pragma once

#include <string>
#include <vector>

namespace tank_datum {

/// A path and what it is, for a message: {"baseline", "2023/datum.json"}.
struct NamedPath {
  std::string name, path;
};

/// The files that a run may write into a result folder, those of tank_N that are there included, and the folder itself.
std::vector<NamedPath> outputsOf(const std::string& folder, const std::string& program);

/// What a run reads of a survey: the file; of a folder, or of its datum.json, every file of the results in it.
std::vector<NamedPath> inputsOf(const std::string& name, const std::string& path);

/// Refuses an output that is, links to, or is a hard link of an input; empty paths are left out.
/// @throws Error (Option) naming both
void requireApart(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs);

}  // namespace tank_datum
