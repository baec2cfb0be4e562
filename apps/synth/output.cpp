#include "output.h"

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

std::unique_ptr<PcdWriter> open(const Command& command, std::size_t station) {
  const int size = command.doubles ? 8 : 4;
  const std::vector<PcdField> fields = {{"x", 'F', size}, {"y", 'F', size}, {"z", 'F', size}, {"intensity", 'F', 4}};
  const auto format = command.ascii ? PcdWriter::Format::Ascii : PcdWriter::Format::Binary;
  return std::make_unique<PcdWriter>(fileOfStation(command, station), fields, format);
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
  const std::size_t files = command.split ? scanStations(scene).size() : 1;
  std::vector<std::unique_ptr<PcdWriter>> writers;
  for (std::size_t i = 0; i < files; ++i) writers.push_back(open(command, i));
  const auto append = [&](std::size_t station, const Rows& rows) {
    writers[command.split ? station : 0]->append(rows);
  };
  const ScanSummary summary = scanScene(scene, append, command.threads);
  writeWhole(command.truth, toJson(truthOf(scene, scene.options().truth_stations)).dump(1) + "\n");
  for (const auto& writer : writers) writer->commit();
  return summary;
}

}  // namespace tank_datum::synth
