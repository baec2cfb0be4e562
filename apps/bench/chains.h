#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stage_meter.h"
#include "tank_datum/datum.h"

namespace tank_datum::bench {

/// What one chain cost on one cloud, and the points it marked.
struct ChainRun {
  std::string name;
  std::uint64_t points = 0;
  std::vector<StageCost> stages;
  std::vector<std::int32_t> candidates;  ///< ascending
};

/// The method's steps 1 to 3 as they are written with PCL alone: pcl::search::KdTree, pcl::NormalEstimationOMP, then
/// nearestKSearch of each point again for the angles.
ChainRun runStock(const Points& points, const DatumOptions& options);

/// The same on a whole file, which pcl::io::loadPCDFile reads.
ChainRun runStock(const std::string& path, const DatumOptions& options);

/// The same steps here, with an engine.
ChainRun runOwn(const Points& points, SearchEngine engine, DatumOptions options);

/// The whole command but for writing its results: the scan's checksum, in a thread beside it where the command takes it
/// so.
ChainRun runCommand(const std::vector<std::string>& paths, const DatumOptions& options, Checksum checksum,
                    Datum& datum);

/// How two runs on the same points agree.
struct Agreement {
  std::size_t both = 0, only_first = 0, only_second = 0;

  /// All but one in a thousand. PCL sums the covariance in float32, which now and then puts an angle on the other side.
  bool same() const { return 1000 * (only_first + only_second) <= both; }
};
Agreement agreementOf(const ChainRun& first, const ChainRun& second);

}  // namespace tank_datum::bench
