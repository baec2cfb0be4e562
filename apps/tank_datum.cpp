#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "background_records.h"
#include "command_line.h"
#include "exit_status.h"
#include "result_folder.h"
#include "stage_clock.h"
#include "tank_datum/core/error.h"
#include "tank_datum/levelling.h"
#include "tank_datum/movement/baseline.h"
#include "tank_datum/report/report.h"
#include "tank_datum/report/report_page.h"
#include "terminal.h"

namespace tank_datum {
namespace {

void writeTimings(const std::string& path, const StageClock& clock) {
  std::ofstream out(path);
  out << clock.json();
  out.close();
  if (!out) throw Error(Error::Kind::File, "report", path, "not written", "a writable file");
}

/// Several tanks have a folder each inside the output folder, a single one has the folder itself.
std::string partOf(const std::vector<Datum>& datums, std::size_t i) {
  return datums.size() > 1 ? "tank_" + std::to_string(i + 1) : "";
}

std::string fileToOpen(const Command& command, const std::string& part) {
  return command.output + "/" + (part.empty() ? "" : part + "/") + (command.no_report ? "datum.json" : "report.html");
}

/// Refuses a baseline that this run would write over.
void requireElsewhere(const std::string& baseline, const std::string& output) {
  const std::filesystem::path file(baseline), folder = std::filesystem::is_directory(file) ? file : file.parent_path();
  std::error_code missing;
  if (!std::filesystem::equivalent(folder.empty() ? "." : folder, output, missing)) return;
  throw Error(Error::Kind::Option, "movement", "baseline", baseline, "a result outside of the output folder " + output);
}

std::vector<Datum> extract(const Command& command, const std::optional<Baseline>& baseline, StageClock& clock) {
  const auto observer = [&clock](const char* stage) { clock.begin(stage); };
  clock.begin("open");
  const double metres = command.metresPerUnit();
  if (!command.levelling.empty()) return {readLevelling(command.levelling, metres, command.diameter, command.options)};
  Scan scan = Scan::open(command.scans, metres);
  scan.setProgress([&](std::uint64_t rows) { clock.progress(rows, scan.size()); });
  const std::vector<Tank> tanks = findTanks(scan, command.options, observer);
  if (baseline) requireAmong(tanks, scan.origin(), *baseline);
  if (command.all) return extractDatumsOf(tanks, scan, command.options, observer);
  return {extractDatumAmong(tanks, scan, command.options, observer)};
}

/// The movement of one of several tanks; of those that are not the baseline's it says so.
Movement movementOf(const Datum& datum, const Baseline& baseline, const Command& command) {
  try {
    return movementSince(baseline, datum, command.options);
  } catch (const Error& error) {
    if (!command.all) throw;
    Movement none;
    none.baseline = baseline.epoch.name;
    none.message = error.what();
    return none;
  }
}

Provenance recordOf(const Datum& datum, const std::vector<InputRecord>& files, const std::optional<Baseline>& baseline,
                    const Command& command) {
  Provenance provenance = provenanceOf(files, command.units, command.options, datum);
  provenance.baseline = command.baseline;
  provenance.movement_options = command.movement;
  if (!baseline || !datum.usable()) return provenance;
  provenance.movement = movementOf(datum, *baseline, command);
  if (!provenance.movement->message.empty()) {
    std::cerr << "tank_datum: no movement: " << provenance.movement->message << "\n";
  }
  return provenance;
}

int run(const Command& command) {
  if (!command.baseline.empty()) requireElsewhere(command.baseline, command.output);
  ResultFolder folder(command.output);
  std::optional<Baseline> baseline;
  if (!command.baseline.empty()) baseline = readBaseline(command.baseline, command.movement, command.options);
  requireValid(command.movement);
  StageClock clock(!command.quiet);
  BackgroundRecords records(command.scans, command.options.threads != 1, !command.no_checksum);
  const std::vector<Datum> datums = extract(command, baseline, clock);
  clock.begin("hash");
  std::vector<InputRecord> files = records.take();
  if (!command.levelling.empty()) files.push_back(recordOfLevelling(command.levelling, datums.front()));
  clock.begin("report");
  for (std::size_t i = 0; i < datums.size(); ++i) {
    const std::string stage = folder.stage(partOf(datums, i));
    const Provenance provenance = recordOf(datums[i], files, baseline, command);
    writeResults(stage, datums[i], provenance);
    if (!command.no_report) writeReportPage(stage, reportPage(datums[i], provenance));
  }
  folder.commit();
  clock.end();
  if (!command.timings.empty()) writeTimings(command.timings, clock);
  bool usable = false;
  for (std::size_t i = 0; i < datums.size(); ++i) {
    if (!command.quiet)
      std::cout << summary(datums[i], showsBlocks()) << "results        " << fileToOpen(command, partOf(datums, i))
                << "\n";
    for (const std::string& warning : warningsOf(datums[i])) std::cerr << "tank_datum: warning: " << warning << "\n";
    usable = usable || datums[i].usable();
    if (!datums[i].usable()) {
      std::cerr << "tank_datum: " << nameOf(datums[i].status) << ": " << datums[i].message << "\n";
    }
  }
  std::cout.flush();
  if (!std::cout) throw Error(Error::Kind::File, "report", "standard output", "not written", "room for the summary");
  return usable ? kUsable : kNoDatum;
}

}  // namespace
}  // namespace tank_datum

int main(int argc, char** argv) {
  using namespace tank_datum;
  Command command;
  int status = kUsable;
  try {
    return parseCommandLine(argc, argv, command, status) ? run(command) : status;
  } catch (const Error& error) {
    std::cerr << "tank_datum: " << error.what() << "\n";
    return error.kind() == Error::Kind::Option ? kWrongUse : kFileFailed;
  } catch (const std::bad_alloc&) {
    std::cerr << "tank_datum: memory: the points near the datum, more than fit, expected a machine with more memory\n";
    return kFileFailed;
  }
}
