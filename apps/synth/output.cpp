#include "output.h"

#include <filesystem>
#include <memory>

#include "io/pcd_writer.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "tank_datum/core/error.h"
#include "truth.h"

namespace tank_datum::synth {
namespace {

constexpr const char* kProgram = "tank_datum_synth";

std::string fileOfStation(const Command& command, std::size_t station) {
  if (!command.split) return command.output;
  const std::filesystem::path whole(command.output);
  const std::string name = whole.stem().string() + "_" + std::to_string(station + 1) + whole.extension().string();
  return (whole.parent_path() / name).string();
}

/// The comment in a scan's head by which it is known again.
const std::string kMark = std::string("made by ") + kProgram;

/// A scan being written beside its place.
struct ScanFile {
  ScanFile(const Command& command, const std::string& path)
      : file((requireReplaceable(path), path), isFileWith("# .PCD", "# " + kMark + "\n"), kProgram),
        writer(file.place(), fieldsOf(command), command.ascii ? PcdWriter::Format::Ascii : PcdWriter::Format::Binary,
               kMark) {}

  static std::vector<PcdField> fieldsOf(const Command& command) {
    const int size = command.doubles ? 8 : 4;
    return {{"x", 'F', size}, {"y", 'F', size}, {"z", 'F', size}, {"intensity", 'F', 4}};
  }

  OutputFile file;
  PcdWriter writer;
};

}  // namespace

ScanSummary writeScan(const Scene& scene, const Command& command) {
  requireReplaceable(command.truth);
  OutputFile truth(command.truth, isJsonWith({"seed", "options", "scanners", "tanks"}), kProgram);
  std::vector<std::unique_ptr<ScanFile>> scans;
  const std::size_t count = command.split ? scanStations(scene).size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    scans.push_back(std::make_unique<ScanFile>(command, fileOfStation(command, i)));
  }
  const auto append = [&](std::size_t station, const Rows& rows) {
    scans[command.split ? station : 0]->writer.append(rows);
  };
  const ScanSummary summary = scanScene(scene, append, command.threads);
  truth.write(toJson(truthOf(scene, scene.options().truth_stations)).dump(1) + "\n");
  std::vector<OutputFile*> files = {&truth};
  for (const auto& scan : scans) {
    scan->writer.commit();
    files.push_back(&scan->file);
  }
  commitTogether(files);
  return summary;
}

}  // namespace tank_datum::synth
