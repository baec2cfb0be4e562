#include "job.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <list>
#include <memory>
#include <mutex>
#include <thread>

#include "core/parallel.h"
#include "core/refusal.h"
#include "datum_stages.h"
#include "foreign.h"
#include "io/up_axis.h"
#include "movement/baseline.h"
#include "movement/movement.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// An array's memory, to be read without the interpreter's lock.
struct Rows {
  const char* data;
  py::ssize_t row_stride, column_stride;
  bool is_double;
  std::uint64_t first, end;  // rows of the whole scan

  double at(std::uint64_t row, int column) const {
    const char* value = data + static_cast<py::ssize_t>(row - first) * row_stride + column * column_stride;
    if (!is_double) {
      float single;
      std::memcpy(&single, value, sizeof single);
      return single;
    }
    double full;
    std::memcpy(&full, value, sizeof full);
    return full;
  }
};

std::vector<Rows> rowsOf(const std::vector<py::array>& arrays) {
  std::vector<Rows> all;
  std::uint64_t first = 0;
  for (const py::array& a : arrays) {
    const std::uint64_t end = first + static_cast<std::uint64_t>(a.shape(0));
    all.push_back({static_cast<const char*>(a.data()), a.strides(0), a.strides(1), a.itemsize() == 8, first, end});
    first = end;
  }
  return all;
}

Scan scanAsGiven(const Points3& points, const std::vector<Rows>& rows, const RunOptions& options) {
  if (!points.paths.empty()) return Scan::open(points.paths, options.metresPerUnit(), options.reading);
  if (!options.reading.setups.empty()) {
    throw Error(Error::Kind::Option, "options", "setups", options.reading.setups.front(), "none: arrays have no names");
  }
  const double scale = options.metresPerUnit();
  const bool single = std::any_of(rows.begin(), rows.end(), [](const Rows& array) { return !array.is_double; });
  const auto row = [rows, scale](std::uint64_t i) {
    std::size_t a = 0;
    while (i >= rows[a].end) ++a;
    return Eigen::Vector3d(rows[a].at(i, 0) * scale, rows[a].at(i, 1) * scale, rows[a].at(i, 2) * scale);
  };
  return Scan::fromRows(rows.empty() ? 0 : rows.back().end, row, {single, scale});
}

Scan scanOf(const Points3& points, const std::vector<Rows>& rows, const RunOptions& options) {
  const Scan scan = scanAsGiven(points, rows, options);
  return options.up == "z" ? scan : scan.turned(upRotation(options.up));
}

/// What the two threads share. The thread that works touches Python's objects only through the gate.
struct Job {
  Points3 points;  // keeps the arrays' memory
  std::vector<Rows> rows;
  RunOptions options;
  std::shared_ptr<PythonGate> gate = std::make_shared<PythonGate>();
  std::atomic<bool> given_up{false};
  std::mutex mutex;
  std::condition_variable told;
  std::vector<std::string> stages;
  bool done = false;
  Result result;
  std::exception_ptr error;

  void work() {
    const ThreadScope threads(options.datum.threads);
    try {
      refuseFirst(firstError(options));
      std::optional<Baseline> baseline;
      if (!options.baseline.empty()) baseline = readBaseline(options.baseline, options.movement, options.datum);
      extract(scanOf(points, rows, options), baseline);
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done = true;
    told.notify_one();
  }

  void extract(const Scan& scan, const std::optional<Baseline>& baseline) {
    Callbacks callbacks;
    callbacks.stage = [this](const char* stage) {
      if (given_up) throw GivenUp();
      const std::lock_guard<std::mutex> lock(mutex);
      stages.emplace_back(stage);
      told.notify_one();
    };
    callbacks.tanks = [&](const std::vector<Tank>& tanks) {
      if (baseline) requireAmong(tanks, scan.origin(), *baseline);
    };
    result.datum = extractDatum(scan, options.datum, callbacks);
    result.provenance =
        provenanceOf(recordInputs(scan, options.checksumTaken()), options.units, options.datum, result.datum);
    result.provenance.up = options.up;
    result.provenance.reading = options.reading;
    result.provenance.reading.foreign = nullptr;  // Python's objects do not leave with the result
    result.provenance.baseline = options.baseline;
    result.provenance.movement_options = options.movement;
    if (baseline && result.datum.usable()) {
      result.provenance.movement = movementSince(*baseline, result.datum, options.datum);
    }
  }
};

/// Jobs given up keep their arrays until they have ended; the list outlives the interpreter on purpose.
std::list<std::shared_ptr<Job>>& abandoned() {
  static auto* jobs = new std::list<std::shared_ptr<Job>>;
  return *jobs;
}

void dropEnded() {
  abandoned().remove_if([](const std::shared_ptr<Job>& job) {
    const std::lock_guard<std::mutex> lock(job->mutex);
    return job->done;
  });
}

/// Waits a tenth of a second at most; true when the job has ended.
bool waitFor(Job& job, std::vector<std::string>& stages) {
  const py::gil_scoped_release unlocked;
  std::unique_lock<std::mutex> lock(job.mutex);
  job.told.wait_for(lock, std::chrono::milliseconds(100), [&] { return job.done || !job.stages.empty(); });
  stages.swap(job.stages);
  return job.done;
}

}  // namespace

Result runJob(Points3 points, const RunOptions& options, const std::function<void(const std::string&)>& progress) {
  dropEnded();
  const auto job = std::make_shared<Job>();
  job->points = std::move(points);
  job->rows = rowsOf(job->points.arrays);
  job->options = options;
  job->options.reading.foreign = foreignReader(job->gate);
  job->options.reading.hash = options.checksumTaken() == Checksum::Xxh3;
  // the arrays must be released with the lock held, so the worker is never the last to hold the job
  abandoned().push_back(job);
  std::thread([raw = job.get()] { raw->work(); }).detach();
  try {
    for (bool ended = false; !ended;) {
      std::vector<std::string> stages;
      ended = waitFor(*job, stages);
      for (const std::string& stage : stages) progress(stage);
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  } catch (...) {
    job->given_up = true;
    job->gate->shut();
    throw;
  }
  abandoned().remove(job);
  if (job->error) std::rethrow_exception(job->error);
  return std::move(job->result);
}

}  // namespace tank_datum::python
