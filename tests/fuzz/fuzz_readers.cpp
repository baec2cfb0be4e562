// The readers of scans and tables, without what is made of them.
#include "fuzz.h"
#include "io/csv_table.h"
#include "io/json_file.h"
#include "setups/agreement.h"
#include "synth/scene_file.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/limits/limits.h"

namespace tank_datum {
namespace {

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

}  // namespace

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

}  // namespace tank_datum
