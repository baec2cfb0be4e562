#include "datum_command.h"

#include <exception>
#include <iostream>
#include <optional>

#include "background_records.h"
#include "command_line.h"
#include "core/parallel.h"
#include "core/printable.h"
#include "core/refusal.h"
#include "datum_stages.h"
#include "exit_status.h"
#include "flag_names.h"
#include "io/up_axis.h"
#include "movement/baseline.h"
#include "report/identity.h"
#include "report/provenance.h"
#include "results/manifest.h"
#include "results/output_file.h"
#include "results/result_folder.h"
#include "run_with_results.h"
#include "stage_clock.h"
#include "tank_datum/core/error.h"
#include "tank_datum/locate/tank.h"
#include "terminal.h"

namespace tank_datum {
namespace {

constexpr const char* kProgram = results::kDatumProgram;

/// The file for the seconds of each stage, if one is asked for.
std::optional<OutputFile> timingsFile(const Command& command) {
  if (command.timings.empty()) return std::nullopt;
  return std::make_optional<OutputFile>(command.timings, isJsonWith({"stages", "total", "peak_memory_bytes"}),
                                        kProgram);
}

/// The file of --json, unless it is standard output.
std::optional<OutputFile> jsonFile(const Command& command) {
  if (command.json.empty() || command.json == "-") return std::nullopt;
  return std::make_optional<OutputFile>(
      command.json, command.all ? isFileWith("[\n{", "\"schema\"") : isJsonWith({"schema", "status", "input"}),
      kProgram);
}

/// datum.json; of all tanks a list of them.
std::string jsonOf(const std::vector<Datum>& datums, const std::vector<Provenance>& provenances,
                   const Command& command) {
  if (!command.all) return datumJson(datums.front(), provenances.front());
  std::string list;
  for (std::size_t i = 0; i < datums.size(); ++i) {
    list += (i == 0 ? "[\n" : ",\n") + datumJson(datums[i], provenances[i]);
    while (list.back() == '\n') list.pop_back();
  }
  return list + "\n]\n";
}

/// Where all tanks are asked for each has a folder inside the output folder; else the one has the folder itself.
std::string partOf(const Command& command, std::size_t i) { return command.all ? "tank_" + std::to_string(i + 1) : ""; }

std::string fileToOpen(const Command& command, const std::string& part) {
  return (part.empty() ? "" : part + "/") + (command.no_report ? "datum.json" : "report.html");
}

Scan scanOf(const Command& command) {
  ScanOptions reading = command.reading;
  reading.hash = command.checksumTaken() == Checksum::Xxh3;
  const Scan scan = Scan::open(command.scans, command.metresPerUnit(), reading);
  return command.up == "z" ? scan : scan.turned(upRotation(command.up));
}

std::vector<Datum> extract(Scan scan, const Command& command, const std::optional<Baseline>& baseline,
                           StageClock& clock) {
  Callbacks callbacks;
  callbacks.stage = [&clock](const char* stage) { clock.begin(stage); };
  scan.setProgress([&](std::uint64_t rows) { clock.progress(rows, scan.size()); });
  callbacks.tanks = [&](const std::vector<Tank>& tanks) {
    if (baseline) requireAmong(tanks, scan.origin(), *baseline);
  };
  if (command.all) return extractEveryDatum(scan, command.datum, callbacks);
  return {extractDatum(scan, command.datum, callbacks)};
}

Provenance recordOf(const Datum& datum, const std::vector<InputRecord>& files, const std::optional<Baseline>& baseline,
                    const Command& command) {
  Provenance provenance = provenanceOf(files, command, baseline, datum);
  if (provenance.movement && !provenance.movement->message.empty()) {
    std::cerr << "tank_datum: no movement: " << printable(withFlags(provenance.movement->message)) << "\n";
  }
  return provenance;
}

/// Writes the files of every tank into the folder, where they wait for its commit.
void stageResults(const ResultFolder& folder, const std::vector<Datum>& datums,
                  const std::vector<Provenance>& provenances, const Command& command) {
  std::vector<IndexEntry> index;
  for (std::size_t i = 0; i < datums.size(); ++i) {
    const std::string stage = folder.stage(partOf(command, i));
    writeResults(stage, datums[i], provenances[i]);
    if (!command.no_report) writeReportPage(stage, reportPage(datums[i], provenances[i]));
    index.push_back({datums[i], provenances[i], fileToOpen(command, partOf(command, i))});
  }
  if (command.all) writeIndexPage(folder.stage(""), indexPage(index));
}

/// Says what was found, on stdout and, of what is not usable, on stderr.
int announce(const std::vector<Datum>& datums, const std::vector<Provenance>& provenances, const Command& command) {
  bool usable = false;
  for (std::size_t i = 0; i < datums.size(); ++i) {
    if (!command.quiet && command.json != "-")
      std::cout << printableLines(withFlags(summary(datums[i], provenances[i], showsBlocks()))) << "results        "
                << printable(command.output) << "/" << fileToOpen(command, partOf(command, i)) << "\n";
    for (const std::string& warning : warningsOf(datums[i]))
      std::cerr << "tank_datum: warning: " << printable(withFlags(warning)) << "\n";
    usable = usable || datums[i].usable();
    if (!datums[i].usable()) {
      std::cerr << "tank_datum: " << nameOf(datums[i].status) << ": " << printable(withFlags(datums[i].message))
                << "\n";
    }
  }
  if (command.all && !command.quiet && command.json != "-")
    std::cout << "index          " << printable(command.output) << "/index.html\n";
  return usable ? kUsable : kNoDatum;
}

/// What a run found, and what it was found in.
struct Extracted {
  std::vector<Datum> datums;
  std::vector<InputRecord> files;
};

Extracted extractRecorded(const Command& command, const std::optional<Baseline>& baseline, StageClock& clock) {
  clock.begin("open");
  if (!command.levelling.empty()) {
    RecordedDatum levelled = readRecordedLevelling(command);
    return {{std::move(levelled.datum)}, {std::move(levelled.file)}};
  }
  const ThreadScope threads(command.datum.threads);
  const Scan scan = scanOf(command);
  BackgroundRecords records(scan, command.checksumTaken(), command.datum.threads);
  std::vector<Datum> datums = extract(scan, command, baseline, clock);
  clock.begin("hash");
  return {std::move(datums), records.take()};
}

/// @param written  set when the results are
int run(const Command& command, bool& written) {
  refuseFirst(firstError(command));
  if (!command.baseline.empty()) settleToRead(command.baseline, kProgram);
  ResultFolder folder(command.output, kProgram);
  std::optional<OutputFile> timings = timingsFile(command), json = jsonFile(command);
  std::optional<Baseline> baseline;
  if (!command.baseline.empty()) baseline = readBaseline(command.baseline, command.movement, command.datum);
  StageClock clock(!command.quiet);
  const auto [datums, files] = extractRecorded(command, baseline, clock);
  clock.begin("report");
  std::vector<Provenance> provenances;
  for (const Datum& datum : datums) {
    provenances.push_back(recordOf(datum, files, baseline, command));
    nameTank(provenances.back().identity, provenances.size(), datums.size());
  }
  stageResults(folder, datums, provenances, command);
  clock.end();
  if (timings) timings->write(clock.json());
  if (json) json->write(jsonOf(datums, provenances, command));
  folder.commit();
  if (timings) timings->commit();
  if (json) json->commit();
  written = true;
  if (command.json == "-") std::cout << jsonOf(datums, provenances, command);
  return announce(datums, provenances, command);
}

}  // namespace

int datumCommand(int argc, char** argv, const OpenForeign& foreign) {
  const auto parse = [&](Command& command, int& status) {
    command.reading.foreign = foreign;
    return parseCommandLine(argc, argv, command, status);
  };
  return runWithResults<Command>(kProgram, parse, run);
}

}  // namespace tank_datum
