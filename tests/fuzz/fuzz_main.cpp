// libFuzzer's way in: one kind of input, TANK_DATUM_FUZZ_READER, is given bytes as libFuzzer makes them. It may be
// refused as an Error; what else is thrown, every wrong access and every overflow is a finding.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "fuzz.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

const Reader& chosenReader() {
  const char* name = std::getenv("TANK_DATUM_FUZZ_READER");
  const auto found = readers().find(name != nullptr ? name : "");
  if (found != readers().end()) return found->second;
  std::cerr << "TANK_DATUM_FUZZ_READER, expected one of";
  for (const auto& [known, reader] : readers()) std::cerr << ' ' << known;
  std::cerr << '\n';
  std::exit(2);
}

/// The file that is read, in memory.
const std::string& place() {
  static const std::string path = [] {
    std::string name = "/dev/shm/tank_datum_fuzz_XXXXXX";
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) std::exit(2);
    return "/proc/self/fd/" + std::to_string((::unlink(name.c_str()), descriptor));
  }();
  return path;
}

}  // namespace
}  // namespace tank_datum

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const tank_datum::Reader& read = tank_datum::chosenReader();
  {
    std::ofstream file(tank_datum::place(), std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  }
  // a file that was just written to is waited for
  constexpr timespec kLongAgo[2] = {{1, 0}, {1, 0}};
  if (::utimensat(AT_FDCWD, tank_datum::place().c_str(), kLongAgo, 0) != 0) std::exit(2);
  try {
    read(tank_datum::place());
  } catch (const tank_datum::Error&) {  // refused
  }
  return 0;
}
