#include "io/whole_file.h"

#include "io/input_file.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

/// "1 MB", "5 bytes"
std::string sizeText(std::uint64_t bytes) {
  const std::uint64_t megabytes = bytes >> 20;
  return megabytes > 0 ? std::to_string(megabytes) + " MB" : std::to_string(bytes) + " bytes";
}

}  // namespace

std::string wholeFile(const std::string& path, const std::string& stage, std::uint64_t largest) {
  try {
    const InputFile file(path);
    if (file.size() > largest) {
      throw fileError("size", path, std::to_string(file.size()) + " bytes", "a file of at most " + sizeText(largest));
    }
    std::string bytes(static_cast<std::size_t>(file.size()), '\0');
    file.read(0, bytes.data(), bytes.size());
    file.requireUnchanged();
    return bytes;
  } catch (const Error& error) {
    throw Error(error.kind(), stage, error.refused());
  }
}

}  // namespace tank_datum
