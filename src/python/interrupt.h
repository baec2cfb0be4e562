#pragma once

#include <pybind11/pybind11.h>

#include <functional>

namespace tank_datum::python {

/// Runs work in a thread of its own without the interpreter's lock, so that the calling thread hears Ctrl-C within a
/// tenth of a second. Work that is given up ends in its next loop; what has not ended half a second later goes on
/// unseen, so work must own all that it touches.
/// @throws what work throws, and pybind11::error_already_set for KeyboardInterrupt
void runInterruptibly(std::function<void()> work);

}  // namespace tank_datum::python
