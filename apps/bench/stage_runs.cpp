#include "stage_runs.h"

#include <array>
#include <filesystem>

#include "chains.h"
#include "locate/crop.h"
#include "locate/sample_ladder.h"
#include "scratch_folder.h"
#include "tank_datum/report/report.h"

namespace tank_datum::bench {
namespace {

/// Writes the results as the command does.
/// @return bytes of the files
std::uint64_t writeReport(const Datum& datum, const Scan& scan, const Command& command, StageMeter& meter) {
  const ScratchFolder scratch(command.folder);
  const std::string folder = scratch.path();
  meter.begin("report");
  const Provenance provenance =
      provenanceOf({{command.scan, scan.size(), Checksum::None, {}}}, "m", command.options, datum);
  writeResults(folder, datum, provenance);
  writeReportPage(folder, reportPage(datum, provenance));
  meter.end();
  std::uint64_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

std::uint64_t shellPointsOf(const Datum& datum) {
  std::uint64_t points = 0;
  for (const ShellPoint& point : datum.shell.points) points += point.points;
  return points;
}

}  // namespace

StageRuns runStages(const Scan& scan, const Ring& ring, std::size_t candidates, const Command& command) {
  RunSizes sizes;
  sizes.file_bytes = std::filesystem::file_size(command.scan);
  sizes.located = scan.size() / strideOf(scan.size());
  sizes.ring = ring.points.size();
  sizes.search = ring.search.size();
  sizes.k = static_cast<std::uint64_t>(command.options.normals.k);
  sizes.candidates = candidates;
  std::array<std::vector<StageCost>, 2> fastest;
  StageRuns runs;
  for (int repeat = 0; repeat < command.repeats; ++repeat) {
    keepFastest(runs.memory, measureMemory());
    for (std::size_t i = 0; i < fastest.size(); ++i) {
      DatumOptions options = command.options;
      options.threads = static_cast<int>(i + 1);
      Datum datum;
      std::vector<StageCost> stages = runCommand({command.scan}, options, command.checksum, datum).stages;
      StageMeter meter;
      sizes.report_bytes = writeReport(datum, scan, command, meter);
      stages.push_back(meter.stages().back());
      keepFastest(fastest[i], stages);
      sizes.cropped = scan.size() / rowStride(scan, datum.tank, command.options.crop);
      sizes.edge = datum.edge_points.size();
      sizes.stations = datum.stations.size();
      sizes.shell = shellPointsOf(datum);
    }
  }
  runs.stages = limitsOf(fastest[0], fastest[1], workOf(sizes), runs.memory.best());
  return runs;
}

}  // namespace tank_datum::bench
