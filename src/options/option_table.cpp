#include "options/option_table.h"

#include "core/length_units.h"
#include "options/option_rows.h"

namespace tank_datum {
namespace {

using namespace option_rows;

std::vector<std::string> unitNames() {
  std::vector<std::string> names;
  for (const auto& [name, metres] : kUnits) names.push_back(name);
  return names;
}

void addDatum(Table& t, DatumOptions& o) {
  t.topic = "The datum";
  t.add("method", "method", choiceOf(o.method, {Method::Refined, Method::Paper}),
        "what z is: two surfaces intersected, or the paper's curve");
  t.add("k", "normals.k", &o.normals.k, "neighbours of a point, itself included").within(atLeast(3));
  t.add("angle_deg", "growing.angle_deg", &o.growing.angle, "theta: normals further apart than this mark a crease")
      .in(Unit::Degrees)
      .within({0, 90, true, true});
  t.add("centre_tolerance", "centre_filter.tolerance", &o.centre_filter.tolerance,
        "distance from the circle within which edge points are kept; 0: 0.1 m or a tenth of the radius")
      .in(Unit::Metres)
      .within(atLeast(0));
  t.add("control_points", "spline.control_points", &o.spline.control_points,
        "control points of the B-spline; 0: the data choose")
      .within({4, 1000, false, false, true});
  t.library("spline.check_every", &o.spline.check_every).within(atLeast(2));
  t.add("search", "normals.search", choiceOf(o.normals.search, {SearchEngine::Flann, SearchEngine::Buckets}),
        "kNN engine: pcl::KdTreeFLANN, or the own tree, which finds the same faster");
  t.library("refine.largest_weld", &o.refine.largest_weld).in(Unit::Metres).within(above(0));
  t.library("refine.widest_band", &o.refine.widest_band).in(Unit::Metres).within(above(0));
  t.library("refine.widest_window", &o.refine.widest_window).in(Unit::Metres).within(above(0));
  t.library("refine.wanted_sigma", &o.refine.wanted_sigma).in(Unit::Metres).within(above(0));
  t.library("refine.profile_points", &o.refine.profile_points).within(atLeast(0)).place = "";
}

void addStations(Table& t, DatumOptions& o) {
  t.add("stations", "stations.count", &o.stations.count, "stations round the tank").within(within(8, 36'000));
  t.add("zero_azimuth_deg", "stations.zero_azimuth_deg", &o.stations.zero_azimuth,
        "where station 0 is, counter-clockwise from +x")
      .in(Unit::Degrees)
      .within(within(-360, 360))
      .ofLevellingsToo();
  t.add("clockwise", "stations.clockwise", &o.stations.clockwise, "stations run clockwise seen from above")
      .withNo()
      .ofLevellingsToo();
  t.add("longest_bridge_deg", "stations.longest_bridge_deg", &o.stations.longest_bridge,
        "arc not seen that is bridged by the curve where it is seen on both sides; 0: none is")
      .in(Unit::Degrees)
      .within({0, 360, false, true});
  t.add("heights", "shell.heights", &o.shell.heights,
        "H,H,... above the datum at which the shell is surveyed; none: 0.3 and every step above")
      .in(Unit::Metres)
      .within(aboveUpTo(0, 100));
  t.add("height_step", "shell.step", &o.shell.step,
        "between the heights of the shell; with the courses' own all are 0.3 m above a seam")
      .in(Unit::Metres)
      .within(atLeast(0.1));
  t.library("shell.half_band", &o.shell.half_band).in(Unit::Metres).within(above(0));
  t.library("shell.reach", &o.shell.reach).in(Unit::Metres).within(above(0));
  t.library("shell.cell_points", &o.shell.cell_points).within(atLeast(50));
}

void addTank(Table& t, RunOptions& run) {
  DatumOptions& o = run.datum;
  t.topic = "The tank";
  t.add("tank", "tank", &o.tank, "X,Y,R of the tank: do not search for it").in(Unit::Metres).within(above(0));
  t.add("pick", "pick", &o.pick, "which of the tanks found, the longest seen arc first").within(atLeast(1));
  t.add("all", "", &run.all, "every tank found, in DIR/tank_1, DIR/tank_2, ..., and DIR/index.html").ofCommand();
  t.topic = "The datum";
  t.library("crop.reach", &o.crop.reach).in(Unit::Metres).within(above(0));
  t.add("search_points", "crop.search_points", &o.crop.search_points,
        "thin the ring to this many points for the edge search")
      .within(atLeast(1000));
  t.add("fit_points", "crop.fit_points", &o.crop.fit_points,
        "of more points in the ring an even share is kept for the fits")
      .within(atLeast(1000));
}

void addSetups(Table& t, RunOptions& run) {
  SetupOptions& o = run.datum.setups;
  t.topic = "Setups of the scanner";
  t.add("setup_error", "setups.error", &o.error,
        "how well setups are registered in height and plan, 1 sigma; 0: estimated from their overlaps")
      .in(Unit::Metres)
      .within(within(0, 1000));
  t.add("setup_tilt_arcsec", "setups.tilt_arcsec", &o.tilt,
        "how well they are levelled, 1 sigma about each axis; 0: estimated from their overlaps")
      .in(Unit::ArcSeconds)
      .within(within(0, 324'000));
  t.add("setup_origins", "setups.origins", Places{&run.setup_origins, &o.origins},
        "CSV file name,x,y,z: where setups stood, by file stem or label");
  t.add("bad_setups", "setups.bad", choiceOf(o.bad, {BadSetups::Free, BadSetups::Drop, BadSetups::Keep}),
        "a setup far off the others: free of priors, dropped where others see the foot too, or kept");
}

void addSearch(Table& t, DatumOptions& o) {
  t.topic = "The tank";
  t.add("min_radius", "locate.min_radius", &o.locate.min_radius, "the smallest tank to look for")
      .in(Unit::Metres)
      .within(above(0));
  t.library("locate.min_arc_deg", &o.locate.min_arc).in(Unit::Degrees).within(aboveUpTo(0, 360));
  t.library("locate.sample_points", &o.locate.sample_points).within(atLeast(10'000));
  t.add("accept", "accept", &o.accept, "take a doubtful tank for one: message says which test it fails");
}

void addInput(Table& t, RunOptions& run) {
  t.topic = "Input";
  t.add("up", "up", choiceOf(run.up, {"x", "y", "z", "-x", "-y", "-z"}),
        "the axis of the scan that is up; results are in the frame turned so");
  t.add("level", "level", &run.datum.level,
        "turn the scan so that the shell stands upright; results are in that frame");
  t.add("units", "", choiceOf(run.units, unitNames()), "units of the input").ofLevellingsToo();
  t.add("las_classes", "las_classes", &run.reading.las_classes,
        "classes of the points of LAS files that are read; none: all; points marked as withheld never are")
      .within(within(0, 255));
  t.add("setups", "setups.names", &run.reading.setups,
        "A,B,... setups of the scanner that are read, by their labels or files; none: all");
}

void addRun(Table& t, RunOptions& run) {
  t.topic = "Results and the run";
  t.add("threads", "", &run.datum.threads, "threads; 0: all cores; the result does not depend on it")
      .within(within(0, 1024));
  t.add("no_report", "", &run.no_report, "no report.html").ofCommand();
  t.add(
      "checksum", "", choiceOf(run.checksum, {Checksum::Xxh3, Checksum::Sha256, Checksum::None}),
      "hash of the scans in datum.json: XXH3-128, which xxhsum -H2 prints; SHA-256, which of a large scan takes longer "
      "than all the rest; none");
  t.add("no_checksum", "", &run.no_checksum, "the same as option checksum none");
  t.add("quiet", "", &run.quiet, "no summary, no progress").ofCommand();
  t.add("timings", "", Path{&run.timings}, "file (JSON) for the seconds of each stage").ofCommand().notInFiles();
  t.add("json", "", Path{&run.json}, "file for datum.json too; -: standard output").ofCommand().notInFiles();
  t.add("config", "", Path{&run.config}, "file with options, as option print_config writes it")
      .ofCommand()
      .notInFiles();
  t.add("print_config", "", &run.print_config, "print the options as a file for option config and stop")
      .ofCommand()
      .notInFiles();
  t.add("print_options", "", &run.print_options, "print all there is to say of each option (JSON) and stop")
      .ofCommand()
      .notInFiles();
}

void addIdentity(Table& t, RunOptions& run) {
  t.topic = "What the report says of the tank";
  t.add("about", "", Path{&run.about},
        "TOML file with tank, product, site, client, company, logo, survey_date, "
        "instrument, inspector, report_number, revision, notes");
  t.add("mark", "", &run.marks, "NAME=DEG,... places at the shell that readers know, by their azimuths");
  t.add("north_deg", "", Fact{&run.north}, "where north is, counter-clockwise from +x")
      .in(Unit::Degrees)
      .within(within(-360, 360));
  t.add("survey_points", "", &run.survey_points,
        "points listed with their elevations, numbered clockwise from north (not given: from +y); 0: none")
      .within({4, 360, false, false, true});
  t.add("display_units", "", choiceOf(run.display_units, {"mm", "in", "ft"}),
        "lengths in report and summary: mm and m, inches and feet, feet; files hold metres");
  t.add("language", "", choiceOf(run.language, {"en", "de", "es", "zh", "ru"}), "of the report");
}

void addChecks(Table& t, RunOptions& run) {
  AnalysisOptions& o = run.datum.analysis;
  TankFacts& facts = o.facts;
  t.topic = "Code checks";
  t.add("height", "analysis.height", Fact{&facts.height},
        "shell height H for the code checks, as 8, 8m, 26.25ft, 315in; a number alone is metres")
      .in(Unit::Metres)
      .within(aboveUpTo(0, 100));
  t.add("yield_mpa", "analysis.yield_mpa", Fact{&facts.yield}, "yield strength Y of the shell's steel")
      .in(Unit::Megapascals)
      .within(aboveUpTo(50, 2000));
  t.add("modulus_mpa", "analysis.modulus_mpa", Fact{&facts.modulus}, "its elastic modulus E")
      .in(Unit::Megapascals)
      .within(aboveUpTo(5e4, 5e5));
  t.add("roof", "analysis.roof", anyOf(facts.roof, {"open", "fixed"}), "open (floating) or fixed");
  t.add("foundation", "analysis.foundation", anyOf(facts.foundation, {"ringwall", "earth"}), "ringwall or earth");
  t.add("service", "analysis.service", choiceOf(facts.service, {Service::New, Service::Rebuilt, Service::InService}),
        "whose rules are judged by: of a new, rebuilt or in-service tank");
  t.add("classic_points", "analysis.classic_points", &o.classic_points,
        "survey points for the classic out-of-plane rule; 0: every 20 ft, or the stations typed in")
      .within(atLeast(0));
  t.add("limits", "analysis.limits", Path{&o.limits_file},
        "file of limits to judge by, as option print_limits writes it");
  t.add("print_limits", "", &run.print_limits,
        "print the limits of the code checks as a file for option limits and stop")
      .ofCommand()
      .notInFiles();
}

void addLevelling(Table& t, RunOptions& run) {
  t.topic = "Input";
  t.add("diameter", "", Fact{&run.diameter}, "of the tank of option stations_csv, as 60, 60m, 196.85ft")
      .in(Unit::Metres)
      .within(aboveUpTo(0, 1000))
      .ofCommand()
      .notInFiles();
  t.add("stations_csv", "", Path{&run.levelling},
        "stations typed in, in place of a scan: azimuth_deg,elevation[,sigma]")
      .ofCommand()
      .notInFiles();
}

}  // namespace

std::vector<Option> optionsOf(RunOptions& run) {
  Table t;
  t.topic = "Results and the run";
  t.add("output", "", Path{&run.output, true}, "folder for the results (default: the first scan's stem + .datum)")
      .ofCommand()
      .notInFiles()
      .letter = 'o';
  t.of_scans = true;
  addDatum(t, run.datum);
  addStations(t, run.datum);
  addTank(t, run);
  addSetups(t, run);
  addSearch(t, run.datum);
  addInput(t, run);
  t.of_scans = false;
  t.topic = "Movement since an earlier survey";
  t.add("baseline", "movement.baseline", Path{&run.baseline}, "datum.json of an earlier survey: movement since then");
  for (const Option& option : movementOptionsOf(run.movement)) t.rows.push_back(option);
  addRun(t, run);
  addChecks(t, run);
  addIdentity(t, run);
  addLevelling(t, run);
  return t.rows;
}

}  // namespace tank_datum
