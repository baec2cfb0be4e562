#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <memory>
#include <mutex>

#include "core/parallel.h"
#include "tank_datum/io/scan.h"

namespace tank_datum::python {

/// Lets threads of the library call Python, one at a time, until it is shut. A thread inside the interpreter when this
/// ends would end the process.
class PythonGate {
 public:
  /// Runs a call with the interpreter's lock held. An exception of Python's becomes an Error, with what it says.
  /// @throws GivenUp behind shut(), Error (File), std::bad_alloc
  void enter(const std::function<void()>& call);

  /// Waits for the call that runs; no other begins. To be called with the interpreter's lock held.
  void shut();

  /// Drops a reference with the lock held; once shut it is kept for good.
  void drop(PyObject* object);

 private:
  std::mutex one_;
  bool shut_ = false;
};

/// Points that an object of Python's yields, see Blocks in tank_datum/_foreign.py. To be called without the
/// interpreter's lock.
ScanBlocks blocksFrom(const std::shared_ptr<PythonGate>& gate, const pybind11::handle& reader, double metres_per_unit);

/// Reads scans through the package's Python readers. To be called with the interpreter's lock held; what it returns
/// is called without.
std::function<ScanBlocks(const ForeignScan&)> foreignReader(const std::shared_ptr<PythonGate>& gate);

}  // namespace tank_datum::python
