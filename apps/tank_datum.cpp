#include <exception>
#include <fstream>
#include <iostream>

#include "command_line.h"
#include "exit_status.h"
#include "result_folder.h"
#include "stage_clock.h"
#include "tank_datum/error.h"
#include "tank_datum/report.h"
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
  return command.output + "/" + (part.empty() ? "" : part + "/") + "datum.json";
}

int run(const Command& command) {
  const std::string error = firstError(command.movement);
  if (!error.empty()) throw Error(Error::Kind::Option, "options", "movement", error, "what the option must be");
  std::optional<Epoch> baseline;  // read before an earlier result in the same folder is moved
  if (!command.baseline.empty()) baseline = readEpoch(command.baseline);
  ResultFolder folder(command.output);
  StageClock clock(!command.quiet);
  const auto observer = [&clock](const char* stage) { clock.begin(stage); };
  clock.begin("open");
  const Scan scan = Scan::open(command.scans, command.metresPerUnit());
  const auto datums = command.all ? extractDatums(scan, command.options, observer)
                                  : std::vector<Datum>{extractDatum(scan, command.options, observer)};
  clock.begin("report");
  for (std::size_t i = 0; i < datums.size(); ++i) {
    Provenance provenance = provenanceOf(command.scans, command.units, command.options, datums[i]);
    if (baseline && datums[i].usable()) {
      provenance.movement =
          compareEpochs(*baseline, epochOf(datums[i], command.options.method, "this survey"), command.movement);
    }
    writeResults(folder.stage(partOf(datums, i)), datums[i], provenance);
  }
  folder.commit();
  clock.end();
  if (!command.timings.empty()) writeTimings(command.timings, clock);
  bool usable = false;
  for (std::size_t i = 0; i < datums.size(); ++i) {
    if (!command.quiet)
      std::cout << summary(datums[i], showsBlocks()) << "results        " << fileToOpen(command, partOf(datums, i))
                << "\n";
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
