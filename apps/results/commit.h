#pragma once

#include <functional>
#include <string>
#include <vector>

#include "results/journal.h"
#include "results/staging.h"

namespace tank_datum::results {

/// Carries out a journal whose new files wait in a staging folder that has entered its commit.
/// @param prefix  begins the lines on stderr: the program's name
/// @throws Error (File)  everything is as it was, or a line says that the next run will make it so
void commit(Staging& staging, const std::string& folder, const Journal& journal, const std::string& prefix);

/// Prints lines to stderr, each with a prefix.
void sayLines(const std::string& prefix, const std::string& lines);

/// Makes the disk have every file and folder below a folder, and names the files relative to it.
std::vector<std::string> syncedFiles(const std::string& folder);

}  // namespace tank_datum::results
