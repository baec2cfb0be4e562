// One reader, TANK_DATUM_FUZZ_READER, is given bytes as libFuzzer makes them. It may refuse them as an Error; what else
// it throws, every wrong access and every overflow is a finding.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <string>

#include "io/csv_table.h"
#include "io/json_file.h"
#include "setups/agreement.h"
#include "synth/scene_file.h"
#include "tank_datum/core/error.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/limits/limits.h"

namespace tank_datum {
namespace {

using Reader = std::function<void(const std::string& path)>;

/// All passes that a run makes: in order, chosen from in threads, thinned, and for labels.
void readScan(const std::string& path) {
  constexpr std::uint64_t kMost = 4'000'000;  // rows, which a compressed block of few bytes may announce
  const Scan scan = Scan::open({path});
  if (scan.size() > kMost) return;
  scan.forEachBlock([](const Points&) {});
  scan.everyNth(3, 2);
  for (const SetupKey& setup : scan.setups()) scan.setupName(setup), scan.setupOrigin(setup);
  scan.coordinateStep();
}

void readTable(const std::string& path) {
  const CsvTable table(path, "fuzz");
  for (std::size_t row = 0; row < table.rows(); ++row) table.number(row, "z");
}

void readSceneFile(const std::string& path) { synth::firstError(synth::readScene(path)); }

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all = {
      {"scan", readScan},
      {"limits", [](const std::string& path) { readLimits(path); }},
      {"origins", [](const std::string& path) { readSetupOrigins(path, 1.0); }},
      {"json", [](const std::string& path) { readJson(path, "fuzz", "JSON"); }},
      {"table", readTable},
      {"scene", readSceneFile},
  };
  return all;
}

const Reader& chosenReader() {
  const char* name = std::getenv("TANK_DATUM_FUZZ_READER");
  const auto found = readers().find(name != nullptr ? name : "");
  if (found != readers().end()) return found->second;
  std::cerr << "fuzz_readers: TANK_DATUM_FUZZ_READER, expected one of";
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
  try {
    read(tank_datum::place());
  } catch (const tank_datum::Error&) {  // refused
  }
  return 0;
}
