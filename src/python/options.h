#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum::python {

/// Options as the command line has them: degrees, and the units of the input.
struct Options {
  DatumOptions datum;
  std::string units = "m";
  std::string baseline;  ///< datum.json or folder of an earlier survey, or empty
  MovementOptions movement;

  double metresPerUnit() const;
};

/// Keyword arguments over the defaults of the C++ structs.
/// @throws py::type_error for an unknown name or a value of the wrong type, Error (Option) for a refused name
Options optionsFrom(const pybind11::dict& keywords);

/// Every keyword and its default.
pybind11::dict defaults();

}  // namespace tank_datum::python
