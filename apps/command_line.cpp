#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "config_lines.h"
#include "core/printable.h"
#include "core/refusal.h"
#include "exit_status.h"
#include "flag_names.h"
#include "option_flags.h"
#include "options/option_json.h"
#include "options/option_table.h"
#include "parsed.h"
#include "report/identity.h"
#include "report/section_json.h"
#include "results/manifest.h"
#include "results/output_guard.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

/// The scans, and what goes with what.
void addRest(CLI::App& app, CLI::Option* scan) {
  scan->configurable(false);
  CLI::Option* levelling = app.get_option("--stations-csv");
  CLI::Option* diameter = app.get_option("--diameter");
  levelling->needs(diameter)->excludes(scan);
  diameter->needs(levelling);
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.set_version_flag("--version", std::string("tank_datum ") + kVersion);
}

/// Refuses a command whose outputs are among its inputs, before any of these is read.
void requireInputsUntouched(const Command& command) {
  std::vector<NamedPath> inputs = inputsOf("baseline", command.baseline);
  for (const std::string& scan : command.scans) inputs.push_back({"scan", scan});
  inputs.push_back({"levelling table", command.levelling});
  inputs.push_back({"limits file", command.datum.analysis.limits_file});
  inputs.push_back({"file of setups' origins", command.setup_origins});
  inputs.push_back({"config file", command.config});
  const std::string json = command.json == "-" ? "" : command.json;  // -: standard output
  std::vector<NamedPath> outputs = outputsOf(command.output, results::kDatumProgram);
  for (const NamedPath& named : {NamedPath{"--timings", command.timings}, NamedPath{"--json", json}}) {
    if (named.path.empty()) continue;
    for (const NamedPath& output : outputs) requireApart({{"result", output.path}}, {named});
    outputs.push_back(named);
  }
  requireApart(inputs, outputs);
}

std::string stemOf(const std::string& scan) { return std::filesystem::path(scan).stem().string() + ".datum"; }

/// A length without a unit is metres, whatever the scan is in: whoever typed the scan's feet should know.
void warnOfMetres(const CLI::App& app, const std::string& flag, const std::string& units) {
  const auto typed = app.get_option(flag)->as<std::string>();
  const bool plain = !typed.empty() && typed.find_first_not_of("0123456789.+-eE ") == std::string::npos;
  if (!plain || units == "m") return;
  std::cerr << "tank_datum: warning: " << flag << ' ' << typed << " is taken for metres, and the input is in " << units
            << ": write " << typed << units << " if that is meant\n";
}

Error notForLevellings(const std::string& flag, const std::string& value) {
  return Error(Error::Kind::Option, "command line", flag, value, "none with --stations-csv");
}

/// Says which options a levelling survey has no use for. Those that have their defaults, as in a printed file of
/// options, are not meant.
/// @throws Error for which tank, or all of them
void warnOfScans(const CLI::App& app, const Command& command) {
  if (command.levelling.empty()) return;
  if (command.all) throw notForLevellings("--all", "true");
  Command plain;
  const auto given = optionsJson(command), defaults = optionsJson(plain);
  for (const Option& option : optionsOf(plain)) {
    if (!option.of_scans || option.giver != Giver::All) continue;
    std::string place = "/" + option.place;
    std::replace(place.begin(), place.end(), '.', '/');
    const nlohmann::ordered_json::json_pointer at(place);
    if (given.at(at) == defaults.at(at)) continue;
    const std::string flag = flagOf(option.name), value = app.get_option(flag)->as<std::string>();
    if (option.name == "tank") throw notForLevellings(flag, value);
    std::cerr << "tank_datum: warning: " << flag << ' ' << printable(value)
              << " is not used: a levelling survey has no scan\n";
  }
}

/// False with the status to leave with when there is nothing more to do.
bool parse(CLI::App& app, int argc, char** argv, const Command& command, int& status) {
  refuseEmptyValues(argc, argv);
  try {
    app.parse(argc, argv);
    const bool prints = command.print_limits || command.print_options || command.print_config;
    if (command.inputs().empty() && !prints) throw CLI::RequiredError("scan");
    return true;
  } catch (const CLI::Success& asked) {  // --help, --version
    status = app.exit(asked);
  } catch (const CLI::FileError& error) {
    std::cerr << "tank_datum: command line: --config, " << printable(error.what()) << ", expected a readable file\n";
    status = kFileFailed;
  } catch (const CLI::ParseError& error) {
    for (const std::string& config : app.get_config_ptr()->results()) requireConfigLines(config);
    std::cerr << "tank_datum: command line: " << printable(withShortWords(error.what()))
              << ", expected what tank_datum --help lists\n";
    status = kWrongUse;
  }
  return false;
}

}  // namespace

bool parseCommandLine(int argc, char** argv, Command& command, int& status) {
  CLI::App app("The datum of a storage tank - the line where its shell meets the foundation - from a laser scan.",
               "tank_datum");
  app.option_defaults()->always_capture_default();
  CLI::Option* scan =
      app.add_option("scan", command.scans, "scan(s) of any format known: scan stations of one tank, in one frame");
  const OptionFlags flags(app, optionsOf(command));
  addRest(app, scan);
  if (!parse(app, argc, argv, command, status)) return false;
  if (command.datum.level && command.all) {
    throw Error(Error::Kind::Option, "command line", "--level", "with --all", "one tank: they need not lean alike");
  }
  command.config = app.get_config_ptr()->as<std::string>();
  requireConfigLines(command.config);
  flags.putTyped();
  if (!command.no_report) command.datum.refine.profile_points = kProfilePoints;
  status = kUsable;
  if (command.print_limits) std::cout << standardLimitsText();
  if (command.print_options) std::cout << optionsListed();
  if (command.print_limits || command.print_options) return false;
  refuseDash(command.output, "; --json - prints datum.json");
  if (command.output.empty() && !command.inputs().empty()) command.output = stemOf(command.inputs().front());
  requireInputsUntouched(command);
  readFilesOf(command);
  readIdentity(command);
  warnOfMetres(app, "--height", command.units);
  warnOfMetres(app, "--diameter", command.units);
  warnOfScans(app, command);
  if (!command.print_config) return true;
  refuseFirst(firstError(command));
  std::cout << app.config_to_str(true, true);
  return false;
}

}  // namespace tank_datum
