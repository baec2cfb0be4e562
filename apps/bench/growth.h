#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "chains.h"

namespace tank_datum::bench {

/// The whole command on a scan of some size.
struct GrowthRun {
  ChainRun chain;
  std::uint64_t bytes = 0;    ///< of the file
  double read_seconds = 0.0;  ///< of reading it and doing nothing, as cat FILE > /dev/null does
  Datum datum;
};

/// A scan of another size, made of a given one.
struct GrownScan {
  const Scan& source;
  const Tank& tank;
  std::uint64_t points = 0;
};

/// Writes a scan of so many points made of a given one: an even share of its points, or of several copies of it, turned
/// about the tank's axis by up to 0.025 degrees and displaced by 1 mm (1 sigma) along each axis.
/// @param path  x, y, z in float32, binary
void writeScanOfSize(const GrownScan& scan, const std::string& path);

/// Makes a scan of so many points in a folder, runs the command on it, and removes it.
GrowthRun runOfSize(const GrownScan& scan, const DatumOptions& options, Checksum checksum, const std::string& folder);

/// The largest difference of two runs' elevations over its standard error, of the stations that both have measured.
double largestInSigmas(const Datum& a, const Datum& b);

}  // namespace tank_datum::bench
