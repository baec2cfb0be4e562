#include <iostream>
#include <optional>

#include "bench/command_line.h"
#include "bench/tables.h"
#include "exit_status.h"
#include "locate/crop.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "run_main.h"
#include "tank_datum/core/error.h"

namespace tank_datum::bench {
namespace {

constexpr const char* kProgram = "tank_datum_bench";

/// The fastest of several runs of every chain; they take turns, so that a busy minute of the machine hits all of them.
std::vector<ChainRun> runOnRing(const Points& points, const Command& command) {
  std::vector<ChainRun> best;
  for (int repeat = 0; repeat < command.repeats; ++repeat) {
    const std::vector<ChainRun> runs = {runStock(points, command.options),
                                        runOwn(points, SearchEngine::Flann, command.options),
                                        runOwn(points, SearchEngine::Buckets, command.options)};
    if (best.empty()) best = runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (totalOf(runs[i].stages).seconds < totalOf(best[i].stages).seconds) best[i] = runs[i];
    }
  }
  return best;
}

Tank tankOf(const Scan& scan, const Command& command) {
  const std::vector<Tank> tanks = findTanks(scan, command.options);
  if (!tanks.empty()) return tanks.front();
  throw Error(Error::Kind::File, "bench", command.scan, "no tank", "a scan of a tank");
}

void growTo(Figures& figures, const Scan& scan, const Tank& tank, const Command& command) {
  constexpr double kMillion = 1e6, kStep = 10.0;
  for (double millions = command.smallest; millions <= command.largest * (1.0 + 1e-9); millions *= kStep) {
    const auto points = static_cast<std::uint64_t>(millions * kMillion);
    figures.growth.push_back(runOfSize({scan, tank, points}, command.options, command.checksum, command.folder));
  }
}

int run(const Command& command) {
  requireApart({{"scan", command.scan}}, {{"--json", command.json}});
  std::optional<OutputFile> json;
  if (!command.json.empty()) json.emplace(command.json, isJsonWith({"ring", "same_candidates", "whole"}), kProgram);
  const Scan scan = Scan::open({command.scan});
  const Tank tank = tankOf(scan, command);
  Figures figures;
  {
    Ring ring = cropRing(scan, tank, command.options.crop, {}, command.options.threads);
    if (ring.search.empty()) thinForSearch(ring, tank, command.options.crop, command.options.threads);
    figures.ring = runOnRing(ring.search, command);
    figures.stages = runStages(scan, ring, figures.ring[1].candidates.size(), command);
  }
  if (scan.size() <= command.stock_points) figures.whole.push_back(runStock(command.scan, command.options));
  Datum datum;
  figures.whole.push_back(runCommand({command.scan}, command.options, command.checksum, datum));
  if (command.scale) growTo(figures, scan, tank, command);
  std::cout << tablesOf(figures);
  if (json) {
    json->write(jsonOf(figures));
    json->commit();
  }
  return sameCandidates(figures) ? kUsable : kNoDatum;
}

}  // namespace
}  // namespace tank_datum::bench

int main(int argc, char** argv) {
  using namespace tank_datum;
  return runMain("tank_datum_bench", [&] {
    bench::Command command;
    int status = kUsable;
    return bench::parseCommandLine(argc, argv, command, status) ? bench::run(command) : status;
  });
}
