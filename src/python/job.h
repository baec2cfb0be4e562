#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "tank_datum/report/report.h"

namespace tank_datum::python {

/// Where the points come from: files, or arrays of shape (n, 3) in float32 or float64 with any strides, in metres.
struct Points3 {
  std::vector<std::string> paths;
  std::vector<pybind11::array> arrays;
};

struct Result {
  Datum datum;
  Provenance provenance;
};

/// Runs the chain in a thread of its own without the interpreter's lock, so that the calling thread hears Ctrl-C within
/// a tenth of a second. A run that is given up ends at its next stage.
/// @param progress  called in the calling thread with each stage's name; what it raises gives the run up
/// @throws Error, and pybind11::error_already_set for KeyboardInterrupt and what progress raises
Result runJob(Points3 points, const RunOptions& options, const std::function<void(const std::string&)>& progress);

}  // namespace tank_datum::python
