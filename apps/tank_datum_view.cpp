#include <vtkObject.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "core/length_units.h"
#include "core/printable.h"
#include "exit_status.h"
#include "parsed.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "results/result_folder.h"
#include "run_main.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"
#include "view/apart.h"
#include "view/display.h"
#include "view/window.h"

namespace tank_datum::view {
namespace {

constexpr const char* kProgram = "tank_datum_view";

const std::map<std::string, Colour> kColours = {
    {"height", Colour::Height}, {"radial", Colour::Radial}, {"distance", Colour::Distance}};

/// What the command line asks for.
struct ViewCommand {
  std::string path, colour = "height", units = "m", screenshot, keys;
  std::vector<std::string> scans;
  int station = -1;
  bool paper = false;
  SceneOptions scene;
};

void addOptions(CLI::App& app, ViewCommand& command) {
  app.add_option("path", command.path, "a folder of results of tank_datum, or a scan: its datum is found first")
      ->required();
  app.add_option("--scan", command.scans, "the scan(s) of the folder, when no longer where datum.json says");
  app.add_option("--units", command.units, "units of a scan; a folder knows its own")->check(CLI::IsMember(kUnits));
  app.add_option("--colour", command.colour, "what the cloud's colour says")->check(CLI::IsMember(kColours));
  app.add_option("--range", command.scene.range,
                 "where the colours end [m]; 0: of height 98 % of the points, radial 0.05, distance 1");
  app.add_option("--exaggeration", command.scene.exaggeration, "of the datum's heights about their mean");
  app.add_option("--points", command.scene.points, "the cloud is thinned to this many points");
  app.add_option("--labels", command.scene.label_every, "label every N-th station; 0: none");
  app.add_option("--station", command.station, "pick this station at the start");
  app.add_option("--keys", command.keys, "keys pressed at the start, as in the window");
  app.add_option("--screenshot", command.screenshot, "write this PNG and stop; without a display on Xvfb, if in PATH");
  app.add_flag("--paper", command.paper, "the picture is light and of the tank alone, as in a report");
  app.set_version_flag("--version", std::string("tank_datum_view ") + kVersion);
  app.footer(std::string("Keys in the window:\n") + kKeys);
}

Error refused(const std::string& what, const std::string& value, const std::string& expected) {
  return Error(Error::Kind::Option, "command line", what, value, expected);
}

void requireValid(const ViewCommand& command) {
  if (const auto error = firstError(command.scene)) throw refused("--" + error->name, error->value, error->expected);
  if (!command.screenshot.empty() && std::filesystem::path(command.screenshot).extension() != ".png") {
    throw refused("--screenshot", command.screenshot, "a file name that ends in .png");
  }
  if (command.station < -1) throw refused("--station", std::to_string(command.station), "a station's number");
  if (command.paper && command.screenshot.empty()) throw refused("--paper", "given", "--screenshot beside it");
}

/// A display that answers: the one there is or, for a picture, a virtual one.
std::unique_ptr<VirtualDisplay> displayFor(const ViewCommand& command) {
  if (displayAnswers()) return nullptr;
  auto display = command.screenshot.empty() ? nullptr : std::make_unique<VirtualDisplay>();
  if (!displayAnswers()) {
    if (display && display->runs()) {
      throw Error(Error::Kind::File, "view", "the display of Xvfb", "no answer", kRoomToDraw);
    }
    const char* name = std::getenv("DISPLAY");
    throw Error(Error::Kind::Option, "view", "DISPLAY", name == nullptr ? "not set" : name,
                "an X display that answers (without a screen: --screenshot, and Xvfb in PATH)");
  }
  return display;
}

/// Refuses a picture in the place of what is shown.
void requireScansUntouched(const ViewCommand& command) {
  std::vector<NamedPath> inputs = inputsOf("result or scan", command.path);
  for (const std::string& scan : command.scans) inputs.push_back({"scan", scan});
  requireApart(inputs, {{"--screenshot", command.screenshot}});
}

/// @param picture  where to write the picture; empty: a window is shown
void show(const ViewCommand& command, const ViewedResult& result, const Points& cloud, const std::string& picture) {
  Window window(result, cloud, command.scene, picture.empty());
  window.pick(command.station);
  for (const char key : command.keys) {
    if (!window.press(key)) throw refused("--keys", std::string(1, key), "keys that h lists");
  }
  if (picture.empty()) return window.run();
  if (command.paper) window.whiten();
  window.screenshot(picture);
}

int run(const ViewCommand& command) {
  requireValid(command);
  requireScansUntouched(command);
  const auto display = displayFor(command);
  const bool folder = std::filesystem::is_directory(command.path);
  if (folder) settleToRead(command.path, kProgram);
  std::optional<OutputFile> picture;
  if (!command.screenshot.empty()) {
    picture.emplace(command.screenshot, isFileWith("\x89PNG", kPictureMark), kProgram);
  }
  const ViewedResult result =
      folder ? readResult(command.path, command.scans) : extractResult(command.path, kUnits.at(command.units));
  if (!result.usable) {
    std::cerr << "tank_datum_view: " << printable(result.status + ": " + result.message) << "\n";
    return kNoDatum;
  }
  if (command.station >= static_cast<int>(result.stations.size())) {
    throw refused("--station", std::to_string(command.station),
                  "less than the " + std::to_string(result.stations.size()) + " stations");
  }
  const Points thinned = thinnedCloud(result, command.scene.points);
  const Points cloud = command.paper ? nearTank(thinned, result) : thinned;
  const auto draw = [&] { show(command, result, cloud, picture ? picture->place() : ""); };
  if (!picture) {
    draw();
  } else {
    drawApart(draw);
    picture->commit();
  }
  return kUsable;
}

}  // namespace
}  // namespace tank_datum::view

int main(int argc, char** argv) {
  using namespace tank_datum;
  vtkObject::GlobalWarningDisplayOff();  // reasons are one line, and ours
  return runMain("tank_datum_view", [&]() -> int {
    CLI::App app("A tank's scan and its datum, to look at.", "tank_datum_view");
    app.option_defaults()->always_capture_default();
    view::ViewCommand command;
    view::addOptions(app, command);
    int status = kUsable;
    if (!parsed(app, argc, argv, status)) return status;
    command.scene.colour = view::kColours.at(command.colour);
    return view::run(command);
  });
}
