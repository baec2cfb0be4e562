#pragma once

#include <string>
#include <vector>

#include "growth.h"
#include "stage_runs.h"

namespace tank_datum::bench {

/// Everything that one run of the bench has measured.
struct Figures {
  std::vector<ChainRun> ring;   ///< on the same points of the ring, the stock chain first
  std::vector<ChainRun> whole;  ///< on the whole file, the stock chain first if it was run
  std::vector<GrowthRun> growth;
  StageRuns stages;  ///< of the command on the whole file
};

/// Tables for a terminal: every stage with its seconds, peak memory and points per second, every ratio; every stage
/// beside what the memory gives.
std::string tablesOf(const Figures& figures);

/// The same figures. Seconds and bytes.
std::string jsonOf(const Figures& figures);

/// Whether the chains on the ring mark the same candidates.
bool sameCandidates(const Figures& figures);

}  // namespace tank_datum::bench
