// What a command line names beside scans, and the command line itself: read as a run reads it, and used.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

#include "command_line.h"
#include "fuzz.h"
#include "io/whole_file.h"
#include "movement/baseline.h"
#include "report/identity.h"
#include "report/provenance.h"
#include "tank_datum/report/report.h"

namespace tank_datum {
namespace {

/// A small scan that every run takes.
std::string scanPath() {
  const char* path = std::getenv("TANK_DATUM_FUZZ_SCAN");
  return path != nullptr ? path : "tests/data/sample.pcd";
}

/// What a result says, of a datum found under the options.
void tell(const Datum& datum, const RunOptions& run, const std::optional<Baseline>& baseline = std::nullopt) {
  const Provenance provenance = provenanceOf({}, run, baseline, datum);
  datumJson(datum, provenance);
  stationsCsv(datum);
  summary(datum, provenance);
  reportPage(datum, provenance);
}

bool parse(std::vector<std::string> words, Command& command) {
  words.insert(words.begin(), "tank_datum");
  std::vector<char*> given;
  for (std::string& word : words) given.push_back(word.data());
  int status = 0;
  return parseCommandLine(static_cast<int>(given.size()), given.data(), command, status);
}

const Datum& sampleDatum() {
  static const Datum datum = [] {
    DatumOptions options;
    options.stations.count = 16;
    return extractDatum(Scan::open({scanPath()}), options);
  }();
  return datum;
}

void readConfig(const std::string& path) {
  Command command;
  parse({scanPath(), "--config", path}, command);
}

void readAbout(const std::string& path) {
  RunOptions run;
  run.about = path;
  readIdentity(run);
  tell(sampleDatum(), run);
}

void readLevels(const std::string& path) {
  RunOptions run;
  run.levelling = path;
  run.diameter = 20.0;
  tell(readLevelling(path, 1.0, run.diameter, run.datum), run);
}

void readEarlier(const std::string& path) {
  const RunOptions run;
  const Baseline baseline = readBaseline(path, run.movement, run.datum);
  tell(sampleDatum(), run, baseline);
}

/// Each line is a word of a command line that is parsed and run, in one thread.
void runOptions(const std::string& path) {
  std::istringstream text(wholeFile(path, "fuzz"));
  std::vector<std::string> words = {scanPath()};
  for (std::string line; std::getline(text, line);) words.push_back(line.substr(0, line.find('\0')));
  Command command;
  if (!parse(words, command) || command.scans.size() != 1 || command.scans.front() != scanPath()) return;
  if (firstError(command)) return;
  const Scan scan = Scan::open(command.scans, command.metresPerUnit(), command.reading);
  command.datum.threads = 1;
  tell(extractDatum(scan, command.datum), command);
}

}  // namespace

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all = {
      {"config", readConfig},    {"about", readAbout},    {"levelling", readLevels},
      {"baseline", readEarlier}, {"options", runOptions},
  };
  for (std::ostream* printed : {&std::cout, &std::cerr}) printed->setstate(std::ios::failbit);  // of no interest
  return all;
}

}  // namespace tank_datum
