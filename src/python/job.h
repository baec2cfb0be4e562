#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "result.h"
#include "tank_datum/report/report.h"

namespace tank_datum::python {

/// Where the points come from: files, arrays of shape (n, 3) in float32 or float64 with any strides, or what an object
/// of Python's yields.
struct Points3 {
  std::vector<std::string> paths;
  std::vector<pybind11::array> arrays;
  pybind11::object blocks;  ///< none: not given
};

/// What a run is asked for.
struct Task {
  enum class Wanted { Datum, Datums, Tanks, Levelling };

  Points3 points;
  RunOptions options;
  Wanted wanted = Wanted::Datum;
  std::string baseline_json;  ///< of an earlier survey in memory, the text of its datum.json; options.baseline names it
};

struct Found {
  std::vector<Result> results;                       ///< one, or one a tank
  std::vector<Tank> tanks;                           ///< best first; of Wanted::Tanks alone
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< of the tanks' coordinates [m]
};

/// Where a run is: in a stage, with so many rows of the scan's read in this pass. `begins` once a stage.
struct Event {
  std::string stage;
  std::uint64_t rows = 0, total = 0;
  bool begins = false;
};

/// Runs the chain in a thread of its own without the interpreter's lock, so that the calling thread hears Ctrl-C within
/// a tenth of a second. A run that is given up ends at its next stage.
/// @param progress  called in the calling thread, at most ten times a second beside the beginnings of stages; what it
///                  raises gives the run up
/// @throws Error, and pybind11::error_already_set for KeyboardInterrupt and what progress raises
Found runJob(Task task, const std::function<void(const Event&)>& progress);

}  // namespace tank_datum::python
