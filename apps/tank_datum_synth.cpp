#include <exception>
#include <iostream>

#include "synth/output.h"
#include "tank_datum/core/error.h"

int main(int argc, char** argv) {
  using namespace tank_datum;
  try {
    synth::Command command;
    int status = 0;
    if (!synth::parseCommandLine(argc, argv, command, status)) return status;
    const synth::Scene scene(command.scene);
    const synth::ScanSummary summary = synth::writeScan(scene, command);
    if (!command.quiet)
      std::cout << summary.points << " points of " << summary.rays << " rays: " << command.output << "\n";
    return 0;
  } catch (const Error& error) {
    std::cerr << "tank_datum_synth: " << error.what() << "\n";
    return error.kind() == Error::Kind::Option ? 2 : 3;
  } catch (const std::exception& error) {
    std::cerr << "tank_datum_synth: failed: " << error.what() << "\n";
    return 3;
  }
}
