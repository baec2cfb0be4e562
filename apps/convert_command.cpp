#include "convert_command.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>

#include "core/parallel.h"
#include "core/printable.h"
#include "core/refusal.h"
#include "exit_status.h"
#include "io/pcd_copy.h"
#include "io/pcd_writer.h"
#include "locate/crop.h"
#include "locate/ring_shape.h"
#include "option_flags.h"
#include "parsed.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "run_main.h"
#include "stage_clock.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

constexpr const char* kProgram = "tank_datum_convert";

/// The comment in a copy's head by which it is known again.
const std::string kMark = std::string("made by ") + kProgram;

struct Command : RunOptions {
  std::vector<std::string> files;  ///< the scans, and the copy last
  bool ring = false;

  std::vector<std::string> scans() const { return {files.begin(), files.end() - 1}; }
  const std::string& copy() const { return files.back(); }
};

/// Those of tank_datum's options that say how scans are read and where the ring is.
std::vector<Option> optionsOfCopy(RunOptions& run) {
  const std::vector<std::string> names = {"units", "las_classes", "setups",  "tank",
                                          "pick",  "min_radius",  "threads", "quiet"};
  std::vector<Option> all = optionsOf(run);
  const auto is_other = [&](const Option& option) {
    return std::find(names.begin(), names.end(), option.name) == names.end();
  };
  all.erase(std::remove_if(all.begin(), all.end(), is_other), all.end());
  return all;
}

bool parseCommandLine(int argc, char** argv, Command& command, int& status) {
  CLI::App app("Copies laser scans of any format known to one PCD that gives tank_datum the same datum.", kProgram);
  app.option_defaults()->always_capture_default();
  app.add_option("file", command.files, "scan(s), which are setups of one tank in one frame, and the PCD to write")
      ->required()
      ->expected(2, -1);
  CLI::Option* ring = app.add_flag("--ring", command.ring,
                                   "only the points near the tank's foot, which its stations are measured from");
  const OptionFlags flags(app, optionsOfCopy(command));
  for (const char* of_tank : {"--tank", "--pick", "--min-radius"}) app.get_option(of_tank)->needs(ring);
  app.set_version_flag("--version", std::string(kProgram) + " " + kVersion);
  if (!parsed(app, argc, argv, status)) return false;
  flags.putTyped();
  return true;
}

/// The ring at the foot of the tank; nothing, and a line on stderr, when there is no such tank.
std::optional<RingShape> ringOf(const Scan& scan, const DatumOptions& options) {
  const std::vector<Tank> tanks = findTanks(scan, options);
  const auto picked = static_cast<std::size_t>(options.pick);
  if (tanks.size() < picked || !tanks[picked - 1].has_foundation) {
    std::cerr << kProgram << ": no_tank: "
              << (tanks.size() < picked ? "only " + std::to_string(tanks.size()) + " found" : "it has no foot")
              << ", and the ring of tank " << picked << " is wanted\n";
    return std::nullopt;
  }
  const Tank& tank = tanks[picked - 1];
  return RingShape(tank, widestReach(tank, options.crop));
}

int run(const Command& command) {
  refuseFirst(firstError(command));
  std::vector<NamedPath> scans;
  for (const std::string& scan : command.scans()) scans.push_back({"scan", scan});
  requireApart(scans, {{"copy", command.copy()}});
  requireReplaceable(command.copy());
  StageClock clock(!command.quiet);
  clock.begin("open");
  const ThreadScope threads(command.datum.threads);
  Scan scan = Scan::open(command.scans(), command.metresPerUnit(), command.reading);
  const auto progress = [&](std::uint64_t rows) { clock.progress(rows, scan.size()); };
  scan.setProgress(progress);
  PcdCopy copy;
  copy.comment = kMark;
  copy.progress = progress;
  if (command.ring) {
    clock.begin("locate");
    const std::optional<RingShape> ring = ringOf(scan, command.datum);
    if (!ring) return kNoDatum;
    copy.wanted = [ring](const Eigen::Vector3d& point) { return ring->holds(point); };
  }
  OutputFile file(command.copy(), isFileWith("# .PCD", "# " + kMark + "\n"), kProgram);
  clock.begin("copy");
  const std::uint64_t points = copyToPcd(scan, file.place(), copy);
  clock.end();
  file.commit();
  if (!command.quiet) std::cout << points << " points of " << scan.size() << ": " << printable(command.copy()) << "\n";
  return kUsable;
}

}  // namespace

int convertCommand(int argc, char** argv, const OpenForeign& foreign) {
  const auto work = [&] {
    Command command;
    command.reading.foreign = foreign;
    int status = kUsable;
    return parseCommandLine(argc, argv, command, status) ? run(command) : status;
  };
  return runMain(kProgram, std::cref(work));
}

}  // namespace tank_datum
