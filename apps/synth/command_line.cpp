#include "command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/printable.h"
#include "io/text_number.h"
#include "results/output_guard.h"
#include "scene_file.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum::synth {
namespace {

using Json = nlohmann::ordered_json;

/// A command line option and the place of its value in a scene file.
struct Setting {
  const char *flag, *place, *help;
};

constexpr Setting kNumbers[] = {
    {"--radius", "/tanks/0/radius", "outer radius of the shell [m]"},
    {"--height", "/tanks/0/height", "of the shell [m]"},
    {"--base-elevation", "/tanks/0/base_elevation", "mean datum elevation [m]"},
    {"--tilt-slope", "/tanks/0/tilt_slope", "tilt [m/m]"},
    {"--tilt-total", "/tanks/0/tilt_total", "tilt as metres across the diameter"},
    {"--tilt-direction-deg", "/tanks/0/tilt_direction_deg", "azimuth of the highest point"},
    {"--lobes", "/tanks/0/lobes/amplitude", "largest out-of-roundness, in lobes of 3-8 m [m]"},
    {"--course-step", "/tanks/0/course_step", "each course is this much thinner than the one below [m]"},
    {"--weld", "/tanks/0/foundation/weld", "leg of the fillet weld [m]"},
    {"--plate-width", "/tanks/0/foundation/plate_width", "lip of the annular plate [m]"},
    {"--plate-thickness", "/tanks/0/foundation/plate_thickness", "of the annular plate [m]"},
    {"--ringwall-width", "/tanks/0/foundation/ringwall_width", "from shell to ringwall edge [m]"},
    {"--pad-width", "/tanks/0/foundation/pad_width", "from shell to shoulder [m]"},
    {"--pad-fall", "/tanks/0/foundation/pad_fall", "slope of the pad, falling outwards"},
    {"--foundation-roughness", "/tanks/0/foundation/roughness", "rms [m]"},
    {"--ground-drop", "/ground/drop", "ground below the datum at its highest side [m]"},
    {"--ground-slope", "/ground/slope", "slope of the ground"},
    {"--ground-roughness", "/ground/roughness", "rms [m]"},
    {"--boxes", "/clutter/boxes", "how many boxes stand about"},
    {"--pipes", "/clutter/pipes", "how many pipes there are"},
    {"--noise", "/measurement/range_sigma", "range noise, 1 sigma at square incidence [m]"},
    {"--incidence-gain", "/measurement/incidence_gain", "growth of the noise with 1/cos(incidence)-1"},
    {"--outliers", "/measurement/outliers", "fraction of returns with a wrong range"},
    {"--scanners", "/scanner/count", "scanner stations"},
    {"--distance", "/scanner/distance", "from the shell; inside: from the centre [m]"},
    {"--step-deg", "/scanner/step_deg", "angle between rays"},
    {"--arc-deg", "/scanner/arc_deg", "the scanners are spread over"},
    {"--first-azimuth-deg", "/scanner/first_azimuth_deg", "of the first scanner"},
    {"--max-range", "/scanner/max_range", "[m]"},
    {"--setup-sigma-dz", "/scanner/registration/sigma_dz", "error of each scanner's height, 1 sigma [m]"},
    {"--setup-sigma-plan", "/scanner/registration/sigma_plan", "of its x and its y, 1 sigma [m]"},
    {"--setup-sigma-tilt-arcsec", "/scanner/registration/sigma_tilt_arcsec", "of its two tilts, 1 sigma"},
    {"--near-datum", "/near_datum", "keep only points this near to the datum line [m]"},
    {"--seed", "/seed", "of everything random"},
};

constexpr Setting kFlags[] = {
    {"--inside", "/scanner/inside", "the scanners stand in the tank"},
    {"--mixed-pixels", "/measurement/mixed_pixels", "beams that straddle an edge return a blend"},
};

constexpr Setting kWords[] = {
    {"--foundation", "/tanks/0/foundation/kind", "pad, annular_plate or crown"},
    {"--roof", "/tanks/0/roof", "none, cone, dome or floating"},
    {"--field", "/scanner/field", "full, or tank: only what a tank fills of it"},
};

/// A list of records of numbers, as in 2:0.003:45,3:0.002:10
struct Records {
  const char *flag, *place, *help;
  std::vector<std::string> keys;
};

const std::vector<Records>& records() {
  static const std::vector<Records> all = {
      {"--harmonics", "/tanks/0/harmonics", "N:AMPLITUDE:PHASE_DEG,...", {"n", "amplitude", "phase_deg"}},
      {"--dips", "/tanks/0/dips", "AZIMUTH_DEG:WIDTH_DEG:DEPTH,...", {"azimuth_deg", "width_deg", "depth"}},
      {"--out-of-round", "/tanks/0/out_of_round", "N:AMPLITUDE:PHASE_DEG,...", {"n", "amplitude", "phase_deg"}},
      {"--soil", "/tanks/0/soil", "AZIMUTH_DEG:WIDTH_DEG:DEPTH,...", {"azimuth_deg", "width_deg", "depth"}},
  };
  return all;
}

/// A number as people type it, .5 and 1. too, which JSON does not know; whole ones stay whole.
Json parsedNumber(const std::string& flag, const std::string& text) {
  Json value = Json::parse(text, nullptr, false);
  if (value.is_number()) return value;
  double number = 0.0;
  const char *end = text.data() + text.size(), *after = parseNumber(text.data(), end, number);
  if (after == end && std::isfinite(number)) return number;
  throw Error(Error::Kind::Option, "options", flag, text, "a number");
}

std::vector<std::string> parts(const std::string& text, char separator) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) all.push_back(part);
  return all;
}

Json parsedRecords(const Records& format, const std::string& text) {
  Json list = Json::array();
  for (const std::string& record : parts(text, ',')) {
    const std::vector<std::string> values = parts(record, ':');
    if (values.size() != format.keys.size())
      throw Error(Error::Kind::Option, "options", format.flag, record, format.help);
    Json one = Json::object();
    for (std::size_t i = 0; i < values.size(); ++i) one[format.keys[i]] = parsedNumber(format.flag, values[i]);
    list.push_back(one);
  }
  return list;
}

Json parsedTriple(const std::string& flag, const std::string& text) {
  Json list = Json::array();
  for (const std::string& value : parts(text, ',')) list.push_back(parsedNumber(flag, value));
  return list;
}

void put(Json& scene, const std::string& place, const Json& value) {
  try {
    scene[Json::json_pointer(place)] = value;
  } catch (const Json::exception&) {
    throw Error(Error::Kind::Option, "options", "key", place, "one a scene file has");
  }
}

/// --set tanks/0/roof_rise=2 sets anything a scene file can hold.
void putPair(Json& scene, const std::string& pair) {
  const std::size_t equals = pair.find('=');
  if (equals == std::string::npos) throw Error(Error::Kind::Option, "options", "--set", pair, "KEY=VALUE");
  Json value = Json::parse(pair.substr(equals + 1), nullptr, false);
  if (value.is_discarded()) value = pair.substr(equals + 1);
  put(scene, "/" + pair.substr(0, equals), value);
}

/// What was given on the command line, as text.
struct Given {
  std::string scene_file, offset;
  std::map<std::string, std::string> numbers, words, records;
  std::map<std::string, bool> flags;
  std::vector<std::string> pairs;
};

void declare(CLI::App& app, Command& command, Given& given) {
  app.add_option("-o,--output", command.output, "the scan to write")->required();
  app.add_option("--truth", command.truth, "true datum (default OUT with .truth.json)");
  app.add_option("--scene", given.scene_file, "scene file; the options below go over it");
  app.add_option("--set", given.pairs, "KEY=VALUE, anything a scene file holds, as tanks/0/radius=12");
  app.add_option("--offset", given.offset, "X,Y,Z added to every coordinate [m]");
  app.add_flag("--ascii", command.ascii, "a text PCD");
  app.add_flag("--double", command.doubles, "coordinates of 8 bytes");
  app.add_flag("--per-setup,--stations-split", command.split,
               "one file per scanner, with its VIEWPOINT: OUT_1.pcd, OUT_2.pcd ...");
  app.add_flag("--label-setups", command.label_setups, "a field `setup` with the number of each point's scanner");
  app.add_flag("--quiet", command.quiet, "say nothing on stdout");
  app.add_option("--threads", command.threads, "0 = as many as the machine has");
  for (const Setting& s : kNumbers) app.add_option(s.flag, given.numbers[s.flag], s.help);
  for (const Setting& s : kWords) app.add_option(s.flag, given.words[s.flag], s.help);
  for (const Setting& s : kFlags) app.add_flag(s.flag, given.flags[s.flag], s.help);
  for (const Records& r : records()) app.add_option(r.flag, given.records[r.flag], r.help);
}

Json overlaid(Json scene, const CLI::App& app, const Given& given) {
  for (const Setting& s : kNumbers)
    if (app.count(s.flag) > 0) put(scene, s.place, parsedNumber(s.flag, given.numbers.at(s.flag)));
  for (const Setting& s : kWords)
    if (app.count(s.flag) > 0) put(scene, s.place, given.words.at(s.flag));
  for (const Setting& s : kFlags)
    if (app.count(s.flag) > 0) put(scene, s.place, given.flags.at(s.flag));
  for (const Records& r : records())
    if (app.count(r.flag) > 0) put(scene, r.place, parsedRecords(r, given.records.at(r.flag)));
  if (app.count("--offset") > 0) put(scene, "/offset", parsedTriple("--offset", given.offset));
  for (const std::string& pair : given.pairs) putPair(scene, pair);
  return scene;
}

/// The files that the command writes; of those of --stations-split the ones that are there.
std::vector<NamedPath> outputsOf(const Command& command) {
  std::vector<NamedPath> all = {{"--output", command.output}, {"--truth", command.truth}};
  const std::filesystem::path whole(command.output), folder = whole.has_parent_path() ? whole.parent_path() : ".";
  std::error_code unknown;
  for (std::filesystem::directory_iterator at(folder, unknown), end; !unknown && at != end; at.increment(unknown)) {
    if (command.split && at->path().filename().string().rfind(whole.stem().string() + "_", 0) == 0) {
      all.push_back({"--output", at->path().string()});
    }
  }
  return all;
}

}  // namespace

bool parseCommandLine(int argc, char** argv, Command& command, int& status) {
  CLI::App app("Simulates a terrestrial laser scan of a storage tank by ray casting, with its true datum.");
  app.set_version_flag("--version", std::string("tank_datum_synth ") + kVersion);
  Given given;
  declare(app, command, given);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    status = app.exit(help);
    return false;
  } catch (const CLI::ParseError& error) {
    std::cerr << "tank_datum_synth: options: " << printable(error.what()) << "\n";
    status = 2;
    return false;
  }
  if (command.truth.empty()) {
    const bool named = command.output.size() > 4 && command.output.substr(command.output.size() - 4) == ".pcd";
    command.truth = (named ? command.output.substr(0, command.output.size() - 4) : command.output) + ".truth.json";
  }
  requireApart({{"scene file", given.scene_file}}, outputsOf(command));
  requireApart({{"scan", command.output}}, {{"--truth", command.truth}});
  const Json file = given.scene_file.empty() ? Json::object() : readJson(given.scene_file);
  command.scene = sceneFromJson(overlaid(file, app, given));
  return true;
}

}  // namespace tank_datum::synth
