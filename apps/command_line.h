#pragma once

#include <string>
#include <vector>

#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// What the command line of tank_datum asks for.
struct Command {
  std::vector<std::string> scans;
  std::string levelling;  ///< file of stations typed in, in place of scans
  double diameter = 0.0;  ///< of their tank [m]
  std::string output;     ///< folder for the results
  std::string units = "m";
  std::string up = "z";  ///< the axis of the scan's frame that is vertical
  std::string baseline;  ///< datum.json or folder of an earlier survey, or empty
  MovementOptions movement;
  std::string timings;  ///< file for the seconds of each stage, or empty
  bool quiet = false;
  bool no_report = false;    ///< no report.html
  bool no_checksum = false;  ///< no SHA-256 of the scans
  bool all = false;          ///< every tank, each in a folder of its own
  DatumOptions options;

  double metresPerUnit() const;
  /// The files that go in: scans, or stations typed in.
  std::vector<std::string> inputs() const { return levelling.empty() ? scans : std::vector<std::string>{levelling}; }
};

/// Reads the arguments; --help, --version and --print-config print and exit.
/// @return true with `command` filled; false with `status` the exit status to leave with
bool parseCommandLine(int argc, char** argv, Command& command, int& status);

}  // namespace tank_datum
