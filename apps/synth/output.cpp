#include "output.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>

#include "io/pcd_writer.h"
#include "tank_datum/core/error.h"
#include "truth.h"

namespace tank_datum::synth {
namespace {

std::string fileOfStation(const Command& command, std::size_t station) {
  if (!command.split) return command.output;
  const std::filesystem::path whole(command.output);
  const std::string name = whole.stem().string() + "_" + std::to_string(station + 1) + whole.extension().string();
  return (whole.parent_path() / name).string();
}

std::unique_ptr<PcdWriter> open(const Command& command, std::size_t station, const std::array<double, 3>& viewpoint) {
  const int size = command.doubles ? 8 : 4;
  std::vector<PcdField> fields = {{"x", 'F', size}, {"y", 'F', size}, {"z", 'F', size}, {"intensity", 'F', 4}};
  if (command.label_setups) fields.push_back({"setup", 'U', 2});
  const auto format = command.ascii ? PcdWriter::Format::Ascii : PcdWriter::Format::Binary;
  return std::make_unique<PcdWriter>(fileOfStation(command, station), fields, format, viewpoint);
}

/// Where the registration says that the scanner stood.
std::array<double, 3> viewpointOf(const Scene& scene, const ScanStation& station) {
  const Eigen::Vector3d at = station.registered(station.position);
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

void writeWhole(const std::string& path, const std::string& text) {
  const std::string temporary = path + ".tmp";
  std::ofstream file(temporary);
  file << text;
  file.close();
  std::error_code failed;
  if (file) std::filesystem::rename(temporary, path, failed);
  if (file && !failed) return;
  std::filesystem::remove(temporary, failed);
  throw Error(Error::Kind::File, "truth", "truth file", path, "a place that can be written");
}

}  // namespace

ScanSummary writeScan(const Scene& scene, const Command& command) {
  requireReplaceable(command.truth);
  const std::vector<ScanStation> stations = scanStations(scene);
  std::vector<std::unique_ptr<PcdWriter>> writers;
  if (command.split) {
    for (std::size_t i = 0; i < stations.size(); ++i)
      writers.push_back(open(command, i, viewpointOf(scene, stations[i])));
  } else {
    writers.push_back(open(command, 0, {}));
  }
  const auto append = [&](std::size_t station, const Rows& rows) {
    writers[command.split ? station : 0]->append(command.label_setups ? labelled(rows, station) : rows);
  };
  const ScanSummary summary = scanScene(scene, append, command.threads);
  writeWhole(command.truth, toJson(truthOf(scene, scene.options().truth_stations)).dump(1) + "\n");
  for (const auto& writer : writers) writer->commit();
  return summary;
}

}  // namespace tank_datum::synth
