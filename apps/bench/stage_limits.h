#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "stage_meter.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::bench {

/// What a stage works on, and what it cannot do without: its input read once and its result written once.
struct StageWork {
  std::uint64_t points = 0;
  double bytes_per_point = kUnknown;  ///< of memory; what lies in the page cache counts as memory
};

/// What a run works on, by which the stages are measured.
struct RunSizes {
  std::uint64_t file_bytes = 0;  ///< of the scan
  std::uint64_t located = 0;     ///< rows that locate looks at
  std::uint64_t cropped = 0;     ///< rows that crop looks at
  std::uint64_t ring = 0;        ///< points kept for the fits
  std::uint64_t search = 0;      ///< of these, for the search of edge points
  std::uint64_t k = 0;           ///< neighbours of each
  std::uint64_t candidates = 0;
  std::uint64_t edge = 0;
  std::uint64_t stations = 0;
  std::uint64_t shell = 0;         ///< points that the survey of the shell measures
  std::uint64_t report_bytes = 0;  ///< of the files written
};

/// The work of each stage, by its name; stages that are not here are not told by points.
std::map<std::string, StageWork> workOf(const RunSizes& sizes);

/// A stage with some number of threads.
struct StageSpeed {
  double seconds = kUnknown;
  double ns_per_point = kUnknown;
  double bandwidth_share = kUnknown;  ///< of what the same number of threads can move
};

/// A stage beside what the machine's memory allows.
struct StageLimit {
  std::string name;
  StageWork work;
  StageSpeed one, two;      ///< threads
  double ratio = kUnknown;  ///< of the seconds of one to those of two
};

/// Bytes a second that one and two threads can move.
struct MemorySpeeds {
  double one = kUnknown, two = kUnknown;
};

StageSpeed speedOf(double seconds, const StageWork& work, double bytes_per_second);

/// @param one,two  the same stages in the same order, with one and with two threads
std::vector<StageLimit> limitsOf(const std::vector<StageCost>& one, const std::vector<StageCost>& two,
                                 const std::map<std::string, StageWork>& work, const MemorySpeeds& memory);

/// Keeps of each stage the fastest of several runs.
void keepFastest(std::vector<StageCost>& best, const std::vector<StageCost>& run);

}  // namespace tank_datum::bench
