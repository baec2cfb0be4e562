#pragma once

#include <cstdint>
#include <string>

#include "tank_datum/datum.h"

namespace tank_datum::bench {

/// What the command line of tank_datum_bench asks for.
struct Command {
  std::string scan;
  std::string json;                        ///< file for the figures, or empty
  std::string folder;                      ///< for the scans that --scale makes, and results
  std::uint64_t stock_points = 8'000'000;  ///< the stock chain is run on whole scans of at most so many
  int repeats = 3;                         ///< of the chains on the ring; the fastest counts
  bool scale = false;
  Checksum checksum = Checksum::Xxh3;      ///< of the scan, by the command
  double smallest = 1.0, largest = 100.0;  ///< scans that --scale makes, each ten times the last [M points]
  DatumOptions options;
};

/// @return true with `command` filled; false with `status` the exit status to leave with
bool parseCommandLine(int argc, char** argv, Command& command, int& status);

}  // namespace tank_datum::bench
