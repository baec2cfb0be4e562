#pragma once

#include <vector>

#include "command_line.h"
#include "memory_speed.h"

namespace tank_datum::bench {

/// The stages of the command with one and with two threads, beside what the memory gives.
struct StageRuns {
  MemorySpeed memory;
  std::vector<StageLimit> stages;  ///< the fastest of several runs of each
};

/// @param ring        of the scan's tank, as the command crops it
/// @param candidates  that region growing marks in it
StageRuns runStages(const Scan& scan, const Ring& ring, std::size_t candidates, const Command& command);

}  // namespace tank_datum::bench
