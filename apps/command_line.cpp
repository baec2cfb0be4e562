#include "command_line.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>

#include "analysis_options.h"
#include "core/length_units.h"
#include "core/units.h"
#include "exit_status.h"
#include "movement_options.h"
#include "results/manifest.h"
#include "results/output_guard.h"
#include "setups/agreement.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

constexpr int kProfilePoints = 90;  // a station's section is plain with them, and 360 of them take 300 kB

const std::map<std::string, Method> kMethods = {{"refined", Method::Refined}, {"paper", Method::Paper}};
const std::map<std::string, SearchEngine> kEngines = {{"flann", SearchEngine::Flann},
                                                      {"buckets", SearchEngine::Buckets}};

const std::map<std::string, BadSetups> kBadSetups = {
    {"free", BadSetups::Free}, {"drop", BadSetups::Drop}, {"keep", BadSetups::Keep}};

/// The figures as a person types them, in degrees; the options hold radians.
struct Typed {
  double angle_deg, zero_azimuth_deg;
  std::string tank, heights, diameter;
  std::string search, method;
  double setup_tilt_arcsec = 0.0;
  std::string setup_origins, bad_setups;
  TypedMovement movement{MovementOptions{}};
  TypedAnalysis analysis;
};

void addOptions(CLI::App& app, Command& command, Typed& typed) {
  DatumOptions& o = command.options;
  CLI::Option* scan = app.add_option("scan", command.scans, "PCD file(s): scan stations of one tank, in one frame");
  scan->configurable(false);
  app.add_option("-o,--output", command.output, "folder for the results (default: the first scan's stem + .datum)")
      ->configurable(false);
  app.add_option("--method", typed.method, "what z is: two surfaces intersected, or the paper's curve")
      ->check(CLI::IsMember(kMethods));
  app.add_option("--k", o.normals.k, "neighbours of a point, itself included");
  app.add_option("--angle-deg", typed.angle_deg, "theta: normals further apart than this mark a crease");
  app.add_option("--centre-tolerance", o.centre_filter.tolerance,
                 "distance from the circle within which edge points are kept [m]; 0: 0.1 m or a tenth of the radius");
  app.add_option("--control-points", o.spline.control_points, "control points of the B-spline; 0: the data choose");
  app.add_option("--search", typed.search, "kNN engine: pcl::KdTreeFLANN, or the own tree, which finds the same faster")
      ->check(CLI::IsMember(kEngines));
  app.add_option("--stations", o.stations.count, "stations round the tank");
  app.add_option("--zero-azimuth-deg", typed.zero_azimuth_deg, "where station 0 is, counter-clockwise from +x");
  app.add_flag("--clockwise,!--no-clockwise", o.stations.clockwise, "stations run clockwise seen from above");
  app.add_option("--heights", typed.heights,
                 "H,H,... above the datum at which the shell is surveyed [m]; none: 0.3 and every step above");
  app.add_option("--height-step", o.shell.step,
                 "between the heights of the shell [m]; with the courses' own all are 0.3 m above a seam");
  CLI::Option* tank = app.add_option("--tank", typed.tank, "X,Y,R of the tank [m]: do not search for it");
  app.add_option("--pick", o.pick, "which of the tanks found, the longest seen arc first");
  CLI::Option* all = app.add_flag("--all", command.all, "every tank found, in DIR/tank_1, DIR/tank_2, ...");
  app.add_option("--search-points", o.crop.search_points, "thin the ring to this many points for the edge search")
      ->check(CLI::PositiveNumber);
  app.add_option("--fit-points", o.crop.fit_points, "of more points in the ring an even share is kept for the fits")
      ->check(CLI::PositiveNumber);
  app.add_option("--setup-error", o.setups.error,
                 "how well setups are registered in height and plan, 1 sigma [m]; 0: estimated from their overlaps");
  app.add_option("--setup-tilt-arcsec", typed.setup_tilt_arcsec,
                 "how well they are levelled, 1 sigma about each axis; 0: estimated from their overlaps");
  app.add_option("--setup-origins", typed.setup_origins,
                 "CSV file name,x,y,z: where setups stood, by file stem or label");
  app.add_option("--bad-setups", typed.bad_setups,
                 "a setup far off the others: free of priors, dropped where others see the foot too, or kept")
      ->check(CLI::IsMember(kBadSetups));
  app.add_option("--min-radius", o.locate.min_radius, "the smallest tank to look for [m]");
  app.add_flag("--accept", o.accept, "take a doubtful tank for one: message says which test it fails");
  app.add_option("--up", command.up, "the axis of the scan that is up; results are in the frame turned so")
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}));
  app.add_flag("--level", o.level, "turn the scan so that the shell stands upright; results are in that frame");
  app.add_option("--units", command.units, "units of the input")->check(CLI::IsMember(kUnits));
  app.add_option("--baseline", command.baseline, "datum.json of an earlier survey: movement since then");
  addMovementOptions(app, command.movement, typed.movement);
  app.add_option("--threads", o.threads, "threads; 0: all cores; the result does not depend on it");
  app.add_flag("--no-report", command.no_report, "no report.html");
  app.add_flag("--no-checksum", command.no_checksum,
               "no SHA-256 of the scans in datum.json: of a large scan it takes longer than all the rest");
  app.add_flag("--quiet", command.quiet, "no summary, no progress");
  app.add_option("--timings", command.timings, "file (JSON) for the seconds of each stage")->configurable(false);
  addAnalysisOptions(app, typed.analysis);
  CLI::Option* diameter =
      app.add_option("--diameter", typed.diameter, "of the tank of --stations-csv, as 60, 60m, 196.85ft");
  CLI::Option* levelling = app.add_option("--stations-csv", command.levelling,
                                          "stations typed in, in place of a scan: azimuth_deg,elevation[,sigma]");
  levelling->needs(diameter)->excludes(scan)->excludes(tank)->excludes(all)->configurable(false);
  diameter->needs(levelling)->configurable(false);
  app.set_config("--config", "", "file with options, as --print-config writes it");
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.set_version_flag("--version", std::string("tank_datum ") + kVersion);
}

/// "X,Y,R"
Circle circleFrom(const std::string& typed) {
  Circle circle;
  char comma = 0, other = 0;
  std::istringstream in(typed);
  in >> circle.center.x() >> comma >> circle.center.y() >> other >> circle.radius;
  if (!in || !(in >> std::ws).eof() || comma != ',' || other != ',') {
    throw Error(Error::Kind::Option, "command line", "--tank", typed, "X,Y,R in metres");
  }
  return circle;
}

/// "H,H,..."
std::vector<double> heightsFrom(const std::string& typed) {
  std::vector<double> heights;
  std::istringstream in(typed);
  for (std::string cell; std::getline(in, cell, ',');) {
    std::istringstream number(cell);
    double height = 0;
    if (!(number >> height) || !(number >> std::ws).eof()) {
      throw Error(Error::Kind::Option, "command line", "--heights", typed, "H,H,... in metres");
    }
    heights.push_back(height);
  }
  return heights;
}

/// Refuses a command whose outputs are among its inputs, before any of these is read.
void requireInputsUntouched(const Command& command, const std::string& limits, const std::string& config) {
  std::vector<NamedPath> inputs = inputsOf("baseline", command.baseline);
  for (const std::string& scan : command.scans) inputs.push_back({"scan", scan});
  inputs.push_back({"levelling table", command.levelling});
  inputs.push_back({"limits file", limits});
  inputs.push_back({"config file", config});
  std::vector<NamedPath> outputs = outputsOf(command.output, results::kDatumProgram);
  if (!command.timings.empty()) {
    for (const NamedPath& output : outputs) requireApart({{"result", output.path}}, {{"--timings", command.timings}});
  }
  outputs.push_back({"--timings", command.timings});
  requireApart(inputs, outputs);
}

std::string stemOf(const std::string& scan) { return std::filesystem::path(scan).stem().string() + ".datum"; }

/// A length without a unit is metres, whatever the scan is in: whoever typed the scan's feet should know.
void warnOfMetres(const char* option, const std::string& typed, const std::string& units) {
  const bool plain = !typed.empty() && typed.find_first_not_of("0123456789.+-eE ") == std::string::npos;
  if (!plain || units == "m") return;
  std::cerr << "tank_datum: warning: " << option << ' ' << typed << " is taken for metres, and the input is in "
            << units << ": write " << typed << units << " if that is meant\n";
}

}  // namespace

double Command::metresPerUnit() const { return kUnits.at(units); }

bool parseCommandLine(int argc, char** argv, Command& command, int& status) {
  CLI::App app("The datum of a storage tank - the line where its shell meets the foundation - from a laser scan.",
               "tank_datum");
  app.option_defaults()->always_capture_default();
  Typed typed;
  typed.angle_deg = command.options.growing.angle / kDegree;
  typed.zero_azimuth_deg = command.options.stations.zero_azimuth / kDegree;
  typed.method = nameOf(command.options.method);
  typed.search = nameOf(command.options.normals.search);
  typed.setup_tilt_arcsec = toArcSeconds(command.options.setups.tilt);
  typed.bad_setups = nameOf(command.options.setups.bad);
  addOptions(app, command, typed);
  bool print_config = false;
  app.add_flag("--print-config", print_config, "print the options as a --config file and stop")->configurable(false);
  bool print_limits = false;
  app.add_flag("--print-limits", print_limits, "print the limits of the code checks as a --limits file and stop")
      ->configurable(false);
  try {
    app.parse(argc, argv);
    if (command.inputs().empty() && !print_limits) throw CLI::RequiredError("scan");
  } catch (const CLI::Success& asked) {  // --help, --version
    status = app.exit(asked);
    return false;
  } catch (const CLI::FileError& error) {
    std::cerr << "tank_datum: command line: --config, " << error.what() << ", expected a readable file\n";
    status = kFileFailed;
    return false;
  } catch (const CLI::ParseError& error) {
    std::cerr << "tank_datum: command line: " << error.what() << ", expected what tank_datum --help lists\n";
    status = kWrongUse;
    return false;
  }
  DatumOptions& o = command.options;
  if (o.level && command.all) {
    throw Error(Error::Kind::Option, "command line", "--level", "with --all", "one tank: they need not lean alike");
  }
  o.growing.angle = typed.angle_deg * kDegree;
  o.stations.zero_azimuth = typed.zero_azimuth_deg * kDegree;
  o.method = kMethods.at(typed.method);
  typed.movement.putInto(command.movement);
  o.normals.search = kEngines.at(typed.search);
  o.setups.tilt = typed.setup_tilt_arcsec / toArcSeconds(1.0);
  o.setups.bad = kBadSetups.at(typed.bad_setups);
  if (!typed.setup_origins.empty()) o.setups.origins = readSetupOrigins(typed.setup_origins, command.metresPerUnit());
  if (!typed.tank.empty()) o.tank = circleFrom(typed.tank);
  o.shell.heights = heightsFrom(typed.heights);
  if (!command.no_report) o.refine.profile_points = kProfilePoints;
  status = kUsable;
  if (print_limits) std::cout << standardLimitsText();
  if (print_limits) return false;
  if (command.output.empty()) command.output = stemOf(command.inputs().front());
  requireInputsUntouched(command, typed.analysis.limits, app.get_config_ptr()->as<std::string>());
  o.analysis = analysisOptions(typed.analysis);
  if (!typed.diameter.empty()) command.diameter = lengthFrom("--diameter", typed.diameter);
  warnOfMetres("--height", typed.analysis.height, command.units);
  warnOfMetres("--diameter", typed.diameter, command.units);
  if (print_config) std::cout << app.config_to_str(true, true);
  return !print_config;
}

}  // namespace tank_datum
