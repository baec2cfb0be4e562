#include "interrupt.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "core/parallel.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// What the two threads share.
struct Run {
  std::function<void()> work;
  std::atomic<bool> given_up{false};
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr error;

  void go() {
    try {
      const CancelScope cancel(given_up);
      work();
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done = true;
    ended.notify_one();
  }

  bool endsWithin(std::chrono::milliseconds time) {
    const py::gil_scoped_release unlocked;
    std::unique_lock<std::mutex> lock(mutex);
    return ended.wait_for(lock, time, [this] { return done; });
  }
};

}  // namespace

void runInterruptibly(std::function<void()> work) {
  const auto run = std::make_shared<Run>();
  run->work = std::move(work);
  std::thread([run] { run->go(); }).detach();
  while (!run->endsWithin(std::chrono::milliseconds(100))) {
    if (PyErr_CheckSignals() == 0) continue;
    const py::error_already_set raised;
    run->given_up = true;
    run->endsWithin(std::chrono::milliseconds(500));
    throw raised;
  }
  if (run->error) std::rethrow_exception(run->error);
}

}  // namespace tank_datum::python
