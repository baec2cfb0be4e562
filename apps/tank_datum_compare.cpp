#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "core/printable.h"
#include "core/units.h"
#include "exit_status.h"
#include "flag_names.h"
#include "io/input_file.h"
#include "io/sha256.h"
#include "movement/epoch.h"
#include "movement/movement.h"
#include "movement/trend.h"
#include "movement_files.h"
#include "option_flags.h"
#include "options/option_table.h"
#include "options/run_options.h"
#include "parsed.h"
#include "report/check_text.h"
#include "report/identity.h"
#include "report/movement_text.h"
#include "report/words.h"
#include "results/manifest.h"
#include "results/output_guard.h"
#include "run_with_results.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

constexpr const char* kProgram = results::kCompareProgram;

struct CompareCommand {
  std::vector<std::string> epochs;  ///< datum.json or result folders, the baseline first
  std::string output = "movement";
  std::vector<std::string> dates;  ///< one per epoch, or none
  MovementOptions options;
  RunOptions told;  ///< of it units and language, and what readers are told of the tank
};

bool parseCommandLine(int argc, char** argv, CompareCommand& command, int& status) {
  CLI::App app("Movement of a tank's datum since the first of its surveys.", "tank_datum_compare");
  app.option_defaults()->always_capture_default();
  app.add_option("epoch", command.epochs, "datum.json or folder of each survey, scanned or levelled, in time order")
      ->required()
      ->expected(2, -1);
  app.add_option("-o,--output", command.output, "folder for movement.json, movement.csv and report.html");
  app.add_option("--dates", command.dates, "of each survey, 2024-05-31 or 2024.41: trends become metres per year")
      ->delimiter(',');
  app.add_option("--display-units", command.told.display_units, "lengths in report and summary; files hold metres")
      ->check(CLI::IsMember({"mm", "in", "ft"}));
  app.add_option("--language", command.told.language, "of the report")->check(CLI::IsMember(languages()));
  std::vector<Option> options = movementOptionsOf(command.options);
  for (const Option& option : optionsOf(command.told)) {
    if (option.name == "about" || option.name == "mark") options.push_back(option);
  }
  const OptionFlags flags(app, options);
  app.set_version_flag("--version", std::string("tank_datum_compare ") + kVersion);
  if (!parsed(app, argc, argv, status)) return false;
  refuseDash(command.output);
  flags.putTyped();
  readIdentity(command.told);
  return true;
}

void print(const Comparison& comparison) {
  std::printf("baseline %s, removed: %s\n", printable(comparison.names.front()).c_str(),
              nameOf(comparison.movements.front().removal));
  const Display display(comparison.readers.display_units);
  const std::string unit = std::string("_") + display.shortUnit();
  const double factor = display.shortFactor();
  const int digits = display.digits(2);
  std::printf("%-32s %8s %8s %8s %8s %8s %12s\n", "survey", "matched", ("rms" + unit).c_str(), ("max" + unit).c_str(),
              "at_deg", ("lod95" + unit).c_str(), "significant");
  for (std::size_t i = 0; i < comparison.movements.size(); ++i) {
    const Movement& m = comparison.movements[i];
    std::printf("%-32s %8zu %8.*f %8.*f %8.1f %8.*f %12zu\n", printable(comparison.names[i + 1]).c_str(), m.matched,
                digits, factor * m.rms, digits, factor * m.max, m.max_azimuth / kDegree, digits, factor * medianLod(m),
                m.significant);
    std::printf("  %s\n", printableLines(withFlags(movementText(m, display, comparison.readers.language))).c_str());
  }
  const StationHistory* fastest = nullptr;
  for (const StationHistory& place : comparison.histories) {
    if (std::isfinite(place.rate) && (!fastest || std::abs(place.rate) > std::abs(fastest->rate))) fastest = &place;
  }
  const std::string limits = limitRatesText(comparison.limit_rates, display, comparison.readers.language);
  std::printf("limits: %s\n", withFlags(limits).c_str());
  if (!fastest) return;
  std::printf("largest trend %.*f +- %.*f %s%s (2 sigma) at %.1f deg\n", digits, factor * fastest->rate, digits,
              2.0 * factor * fastest->sigma_rate, display.shortUnit(), trendUnit(comparison) + 1,
              fastest->azimuth / kDegree);
}

/// @param written  set when the results are
int run(const CompareCommand& command, bool& written) {
  std::vector<NamedPath> inputs;
  for (const std::string& epoch : command.epochs) {
    for (const NamedPath& input : inputsOf("survey", epoch)) inputs.push_back(input);
  }
  if (!command.told.about.empty()) inputs.push_back({"file about the tank", command.told.about});
  requireApart(inputs, outputsOf(command.output, kProgram));
  for (const std::string& epoch : command.epochs) settleToRead(epoch, kProgram);
  ResultFolder folder(command.output, kProgram);
  requireValid(command.options);
  timesOf(command.dates, command.epochs.size());  // refuses bad ones before anything is read
  std::vector<Epoch> epochs;
  Comparison comparison{command.epochs, {}, command.dates, {}, {}, {}, command.options, *command.told.identity};
  for (const std::string& path : command.epochs) {
    const InputFile file(epochFile(path));
    epochs.push_back(readEpoch(path));
    comparison.hashes.push_back(sha256OfFile(file.path()));
    file.requireUnchanged();
  }
  comparison.movements = compareWithFirst(epochs, command.options);
  for (const Movement& m : comparison.movements) {
    if (m.valid()) continue;
    std::cerr << "tank_datum_compare: movement: "
              << printable(withFlags(m.message) + resultsLeft(command.output, kProgram, false)) << "\n";
    return kNoDatum;
  }
  followOverTime(comparison, std::move(epochs));
  writeMovement(folder, comparison);
  folder.commit();
  written = true;
  print(comparison);
  return kUsable;
}

}  // namespace
}  // namespace tank_datum

int main(int argc, char** argv) {
  using namespace tank_datum;
  return runWithResults<CompareCommand>(
      kProgram, [&](auto& command, int& status) { return parseCommandLine(argc, argv, command, status); }, run);
}
