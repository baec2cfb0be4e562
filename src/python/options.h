#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "options/run_options.h"

namespace tank_datum::python {

/// Keyword arguments over the defaults of the C++ structs; the files that they name are read.
/// @throws py::type_error for an unknown name or a value of the wrong type, Error for what is refused or cannot be read
/// @param function  of Python, for messages
RunOptions optionsFrom(const pybind11::dict& keywords, const std::string& function);

/// The same of a comparison's.
MovementOptions movementOptionsFrom(const pybind11::dict& keywords);

/// Every keyword and its default.
pybind11::dict defaults();

/// The keywords that a levelling survey has no use for, in the order of defaults().
pybind11::list keywordsOfScans();

/// A line for each keyword: its name, what it is, in what unit and what it must be.
std::string keywordHelp();

}  // namespace tank_datum::python
