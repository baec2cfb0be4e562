#include <exception>
#include <iostream>

#include "core/printable.h"
#include "exit_status.h"
#include "run_main.h"
#include "synth/output.h"
#include "tank_datum/core/error.h"

int main(int argc, char** argv) {
  using namespace tank_datum;
  return runMain("tank_datum_synth", [&]() -> int {
    synth::Command command;
    int status = kUsable;
    if (!synth::parseCommandLine(argc, argv, command, status)) return status;
    const synth::Scene scene(command.scene);
    const synth::ScanSummary summary = synth::writeScan(scene, command);
    if (!command.quiet)
      std::cout << summary.points << " points of " << summary.rays << " rays: " << printable(command.output) << "\n";
    return kUsable;
  });
}
