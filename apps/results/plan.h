#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/journal.h"

namespace tank_datum::results {

/// What a commit will do to a result folder, and what there is to say of it.
struct Plan {
  Journal journal;
  std::string manifest;           ///< the new manifest.json
  std::vector<std::string> said;  ///< a line for each thing of somebody else that gets another name
};

/// Compares what stands in a folder with what is to be there. An own file of an earlier run, known from the manifest
/// and as it was written, gives way. So does one that a run before there were manifests left, of the names of the
/// contract alone. Whatever else stands in the way - somebody else's, or changed since - is kept under another name.
/// @param added  SHA-256 of the new files, by path
/// @throws Error (File)
Plan planOf(const std::string& folder, const std::string& program, const std::map<std::string, std::string>& added);

}  // namespace tank_datum::results
