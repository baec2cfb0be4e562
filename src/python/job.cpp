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
#include "movement/epoch.h"
#include "report/identity.h"
#include "report/provenance.h"

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

Scan scanOfRows(const std::vector<Rows>& rows, const RunOptions& options) {
  const double scale = options.metresPerUnit();
  const bool single = std::any_of(rows.begin(), rows.end(), [](const Rows& array) { return !array.is_double; });
  const auto row = [rows, scale](std::uint64_t i) {
    const auto in =
        std::upper_bound(rows.begin(), rows.end(), i, [](std::uint64_t at, const Rows& a) { return at < a.end; });
    return Eigen::Vector3d(in->at(i, 0) * scale, in->at(i, 1) * scale, in->at(i, 2) * scale);
  };
  return Scan::fromRows(rows.empty() ? 0 : rows.back().end, row, {single, scale});
}

/// What the two threads share. The thread that works touches Python's objects only through the gate.
struct Job {
  Task task;  // keeps the arrays' memory
  std::vector<Rows> rows;
  std::shared_ptr<PythonGate> gate = std::make_shared<PythonGate>();
  std::atomic<bool> given_up{false};
  std::mutex mutex;
  std::condition_variable told;
  std::vector<Event> events;
  std::string stage;
  bool done = false;
  Found found;
  std::exception_ptr error;

  void work() {
    const ThreadScope threads(task.options.datum.threads);
    const CancelScope cancel(given_up);
    try {
      refuseFirst(firstError(task.options));
      task.wanted == Task::Wanted::Levelling ? level(baselineAsGiven()) : search(baselineAsGiven());
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex);
    done = true;
    told.notify_one();
  }

  std::optional<Baseline> baselineAsGiven() const {
    const RunOptions& o = task.options;
    if (o.baseline.empty()) return std::nullopt;
    if (task.baseline_json.empty()) return readBaseline(o.baseline, o.movement, o.datum);
    return baselineOf(epochIn(task.baseline_json, o.baseline), o.movement, o.datum);
  }

  void tell(const Event& event) {
    const std::lock_guard<std::mutex> lock(mutex);
    const bool later = !events.empty() && !event.begins && !events.back().begins;
    if (later) events.back() = event;
    if (!later) events.push_back(event);
    told.notify_one();
  }

  Callbacks callbacksFor(const Scan& scan, const std::optional<Baseline>& baseline) {
    Callbacks callbacks;
    callbacks.stage = [this, total = scan.size()](const char* name) {
      if (given_up) throw GivenUp();
      stage = name;
      tell({stage, 0, total, true});
    };
    callbacks.tanks = [&](const std::vector<Tank>& tanks) {
      if (baseline) requireAmong(tanks, scan.origin(), *baseline);
    };
    return callbacks;
  }

  Scan scanAsGiven() const {
    const RunOptions& o = task.options;
    if (!task.points.paths.empty()) return Scan::open(task.points.paths, o.metresPerUnit(), o.reading);
    if (!o.reading.setups.empty()) {
      throw Error(Error::Kind::Option, "options", "setups", o.reading.setups.front(), "none: arrays have no names");
    }
    if (!task.points.blocks) return scanOfRows(rows, o);
    return Scan::fromBlocks(blocksFrom(gate, task.points.blocks, o.metresPerUnit()));
  }

  void search(const std::optional<Baseline>& baseline) {
    const Scan given = scanAsGiven();
    Scan scan = task.options.up == "z" ? given : given.turned(upRotation(task.options.up));
    scan.setProgress([this, total = scan.size()](std::uint64_t read) { tell({stage, read, total, false}); });
    const Callbacks callbacks = callbacksFor(scan, baseline);
    const DatumOptions& options = task.options.datum;
    if (task.wanted == Task::Wanted::Tanks) {
      found.tanks = findTanks(scan, options, callbacks);
      found.origin = scan.origin();
      return;
    }
    std::vector<Datum> datums = task.options.all ? extractEveryDatum(scan, options, callbacks)
                                                 : std::vector<Datum>{extractDatum(scan, options, callbacks)};
    keep(std::move(datums), records(scan), baseline);
  }

  std::vector<InputRecord> records(const Scan& scan) const {
    return recordInputs(scan, task.options.checksumTaken(), [this] { return !given_up; });
  }

  void level(const std::optional<Baseline>& baseline) {
    RecordedDatum levelled = readRecordedLevelling(task.options);
    keep({std::move(levelled.datum)}, {levelled.file}, baseline);
  }

  void keep(std::vector<Datum> datums, const std::vector<InputRecord>& files, const std::optional<Baseline>& baseline) {
    for (Datum& datum : datums) {
      Provenance provenance = provenanceOf(files, task.options, baseline, datum);
      nameTank(provenance.identity, found.results.size() + 1, datums.size());
      found.results.push_back({std::move(datum), std::move(provenance)});
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
bool waitFor(Job& job, std::vector<Event>& events) {
  const py::gil_scoped_release unlocked;
  std::unique_lock<std::mutex> lock(job.mutex);
  job.told.wait_for(lock, std::chrono::milliseconds(100),
                    [&] { return job.done || (!job.events.empty() && job.events.front().begins); });
  events.swap(job.events);
  return job.done;
}

}  // namespace

Found runJob(Task task, const std::function<void(const Event&)>& progress) {
  dropEnded();
  const auto job = std::make_shared<Job>();
  job->task = std::move(task);
  job->rows = rowsOf(job->task.points.arrays);
  job->task.options.reading.foreign = foreignReader(job->gate);
  job->task.options.reading.hash = job->task.options.checksumTaken() == Checksum::Xxh3;
  // the arrays must be released with the lock held, so the worker is never the last to hold the job
  abandoned().push_back(job);
  std::thread([raw = job.get()] { raw->work(); }).detach();
  try {
    for (bool ended = false; !ended;) {
      std::vector<Event> events;
      ended = waitFor(*job, events);
      for (const Event& event : events) progress(event);
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
  } catch (...) {
    job->given_up = true;
    job->gate->shut();
    throw;
  }
  abandoned().remove(job);
  if (job->error) std::rethrow_exception(job->error);
  return std::move(job->found);
}

}  // namespace tank_datum::python
