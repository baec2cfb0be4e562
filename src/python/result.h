#pragma once

#include <pybind11/numpy.h>

#include "tank_datum/movement/movement.h"
#include "tank_datum/report/report.h"

namespace tank_datum::python {

/// A datum and where it comes from.
struct Result {
  Datum datum;
  Provenance provenance;
};

/// The class Result of the module: the figures as arrays and dicts, and the files that the command writes.
void addResult(pybind11::module_& module);

/// The single stages on arrays: neighbours, normals, candidates, edge points.
void addStages(pybind11::module_& module);

/// Comparison of surveys, the paper's curves, the codes' limits.
void addStudies(pybind11::module_& module);

/// What is written: result folders, the files of a comparison; the simulated scanner. Of the programs.
void addPrograms(pybind11::module_& module);

/// A comparison's arrays: the movement of every station, and the trend of every place.
pybind11::array movementTable(const Movement& movement);
pybind11::array trendTable(const std::vector<StationHistory>& histories);

}  // namespace tank_datum::python
