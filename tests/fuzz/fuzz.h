#pragma once

#include <functional>
#include <map>
#include <string>

namespace tank_datum {

/// Reads a file as the tool does.
using Reader = std::function<void(const std::string& path)>;

/// The kinds of files that a fuzzer knows, by name.
const std::map<std::string, Reader>& readers();

}  // namespace tank_datum
