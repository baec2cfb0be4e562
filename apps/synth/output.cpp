#include "output.h"

#include <array>
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

/// Where the registration says that the scanner stood.
std::array<double, 3> viewpointOf(const Scene& scene, const ScanStation& station) {
  const Eigen::Vector3d at = scene.inFrame(station.registered(station.position));
  const auto& offset = scene.options().offset;
  return {at.x() + offset[0], at.y() + offset[1], at.z() + offset[2]};
}

/// Rows with the number of the scanner behind each, counted from 1.
Rows labelled(const Rows& rows, std::size_t station) {
  constexpr std::size_t kColumns = 4;
  Rows with;
  with.reserve(rows.size() / kColumns * (kColumns + 1));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    with.push_back(rows[i]);
    if (i % kColumns == kColumns - 1) with.push_back(static_cast<double>(station + 1));
  }
  return with;
}

/// A scan being written beside its place.
struct ScanFile {
  ScanFile(const Command& command, const std::string& path, const std::array<double, 3>& viewpoint)
      : file((requireReplaceable(path), path), isFileWith("# .PCD", "# " + kMark + "\n"), kProgram),
        writer(file.place(), fieldsOf(command), command.ascii ? PcdWriter::Format::Ascii : PcdWriter::Format::Binary,
               {kMark, viewpoint}) {}

  static std::vector<PcdField> fieldsOf(const Command& command) {
    const int size = command.doubles ? 8 : 4;
    std::vector<PcdField> fields = {{"x", 'F', size}, {"y", 'F', size}, {"z", 'F', size}, {"intensity", 'F', 4}};
    if (command.label_setups) fields.push_back({"setup", 'U', 2});
    return fields;
  }

  OutputFile file;
  PcdWriter writer;
};

}  // namespace

ScanSummary writeScan(const Scene& scene, const Command& command) {
  requireReplaceable(command.truth);
  OutputFile truth(command.truth, isJsonWith({"seed", "options", "scanners", "tanks"}), kProgram);
  const std::vector<ScanStation> stations = scanStations(scene);
  std::vector<std::unique_ptr<ScanFile>> scans;
  for (std::size_t i = 0; i < (command.split ? stations.size() : 1); ++i) {
    const auto viewpoint = command.split ? viewpointOf(scene, stations[i]) : std::array<double, 3>{};
    scans.push_back(std::make_unique<ScanFile>(command, fileOfStation(command, i), viewpoint));
  }
  const auto append = [&](std::size_t station, const Rows& rows) {
    scans[command.split ? station : 0]->writer.append(command.label_setups ? labelled(rows, station) : rows);
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
