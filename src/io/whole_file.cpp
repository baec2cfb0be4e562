#include "io/whole_file.h"

#include "io/input_file.h"
#include "io/io_error.h"

namespace tank_datum {

std::string wholeFile(const std::string& path, const std::string& stage, std::uint64_t largest) {
  try {
    const InputFile file(path);
    if (file.size() > largest) {
      throw fileError("size", path, std::to_string(file.size()) + " bytes",
                      "a file of at most " + std::to_string(largest) + " bytes");
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
