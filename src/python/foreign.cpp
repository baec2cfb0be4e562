#include "foreign.h"

#include <pybind11/stl.h>

#include <array>
#include <cstring>
#include <map>
#include <new>
#include <optional>
#include <tuple>

#include "las_block.h"
#include "tank_datum/core/error.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

using Shared = std::shared_ptr<PyObject>;  // dropped through the gate, by whichever thread is the last
using Setup = std::tuple<std::string, std::optional<std::array<double, 3>>>;

Shared shared(py::object object, const std::shared_ptr<PythonGate>& gate) {
  return {object.release().ptr(), [gate](PyObject* owned) { gate->drop(owned); }};
}

/// What Python raised, as the library says it; the package's readers raise Unreadable(thing, value, expected).
[[noreturn]] void rethrow(const py::error_already_set& raised) {
  if (raised.matches(PyExc_MemoryError)) throw std::bad_alloc();
  if (raised.matches(py::module_::import("tank_datum._foreign").attr("Unreadable"))) {
    const auto [thing, value, expected] =
        raised.value().attr("args").cast<std::tuple<std::string, std::string, std::string>>();
    throw Error(Error::Kind::File, "io", thing, value, expected);
  }
  throw Error(Error::Kind::File, "io", "a reader in Python", raised.what(), "no such failure: please report it");
}

/// An object of Python's that gives blocks.
struct Reader {
  std::shared_ptr<PythonGate> gate;
  Shared object;
  double metres_per_unit;
  std::string path;  // empty: it reads no file

  /// The gate's, with the file in what is thrown.
  void enter(const std::function<void()>& call) const {
    try {
      gate->enter(call);
    } catch (const Error& error) {
      Refusal refused = error.refused();
      refused.file = path;
      throw Error(error.kind(), error.stage(), refused);
    }
  }
};

Eigen::Vector3d vectorOf(const std::array<double, 3>& xyz) { return {xyz[0], xyz[1], xyz[2]}; }

/// Fills a block with points, setups, invalid, left_out.
void fill(const py::object& item, double metres_per_unit, ScanBlocks::Block& block) {
  using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;
  using Numbers = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;
  const auto [points, setups, invalid, left_out] = item.cast<std::tuple<Rows, Numbers, std::uint64_t, std::uint64_t>>();
  const auto rows = static_cast<std::size_t>(points.shape(0));
  block.points.resize(rows);
  if (rows > 0) std::memcpy(block.points.front().data(), points.data(), rows * 3 * sizeof(double));
  if (metres_per_unit != 1.0) {
    for (Eigen::Vector3d& p : block.points) p *= metres_per_unit;
  }
  block.setups.clear();
  if (setups.ndim() == 0) {
    block.setup = *setups.data();
  } else {
    block.setups.assign(setups.data(), setups.data() + setups.size());
  }
  block.invalid = invalid;
  block.left_out = left_out;
}

/// Fills a block with the next that an iterator of Python's yields. A LasBlock is decoded by whom looks at it, while
/// Python reads the next one.
bool fetch(PyObject* iterator, const Reader& reader, ScanBlocks::Block& block) {
  auto item = py::reinterpret_steal<py::object>(PyIter_Next(iterator));
  if (!item) {
    if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    return false;
  }
  block.finish = nullptr;
  if (py::isinstance<LasBlock>(item)) {
    const auto* las = item.cast<const LasBlock*>();
    const auto place = std::make_shared<LasBlock::Place>();
    block.finish = [las, kept = shared(item, reader.gate), unit = reader.metres_per_unit,
                    place](ScanBlocks::Block& some) { return las->decode(unit, *place, some); };
  } else {
    fill(item, reader.metres_per_unit, block);
  }
  return true;
}

/// A pass over what a method of a reader yields.
template <class Argument>
ScanBlocks::Next begin(const Reader& reader, const char* method, const Argument& argument) {
  Shared iterator;
  reader.enter([&] { iterator = shared(py::handle(reader.object.get()).attr(method)(argument), reader.gate); });
  return [reader, iterator](ScanBlocks::Block& block) {
    bool more = false;
    reader.enter([&] { more = fetch(iterator.get(), reader, block); });
    return more;
  };
}

ScanBlocks blocksOf(const Reader& reader) {
  const py::handle given(reader.object.get());
  ScanBlocks blocks;
  blocks.size = given.attr("size").cast<std::uint64_t>();
  blocks.coordinate_step = given.attr("step").cast<double>() * reader.metres_per_unit;
  blocks.tells_setups = given.attr("tells_setups").cast<bool>();
  for (const auto& [number, setup] : given.attr("setups").cast<std::map<std::uint32_t, Setup>>()) {
    const auto& [name, place] = setup;
    ScanBlocks::Setup& known = blocks.setups[number];
    known.name = name;
    if (place) known.viewpoint = vectorOf(*place) * reader.metres_per_unit;
  }
  using Numbers = std::vector<std::uint32_t>;
  blocks.start = [reader] { return begin(reader, "blocks", std::optional<Numbers>()); };
  if (given.attr("lists_setups").cast<bool>()) {
    blocks.start_some = [reader](const Numbers& wanted) { return begin(reader, "blocks", wanted); };
  }
  blocks.parts = given.attr("parts").cast<std::uint64_t>();
  blocks.start_every = [reader](std::uint64_t n) { return begin(reader, "every", n); };
  return blocks;
}

}  // namespace

void PythonGate::enter(const std::function<void()>& call) {
  const std::lock_guard<std::mutex> alone(one_);
  if (shut_) throw GivenUp();
  const py::gil_scoped_acquire locked;
  try {
    call();
  } catch (const py::error_already_set& raised) {
    rethrow(raised);
  }
}

void PythonGate::shut() {
  const py::gil_scoped_release unlocked;
  const std::lock_guard<std::mutex> alone(one_);
  shut_ = true;
}

void PythonGate::drop(PyObject* object) {
  if (PyGILState_Check() == 1) {
    Py_DECREF(object);
    return;
  }
  const std::lock_guard<std::mutex> alone(one_);
  if (shut_) return;
  const py::gil_scoped_acquire locked;
  Py_DECREF(object);
}

ScanBlocks blocksFrom(const std::shared_ptr<PythonGate>& gate, const py::handle& reader, double metres_per_unit) {
  ScanBlocks blocks;
  gate->enter([&] {
    blocks = blocksOf({gate, shared(py::reinterpret_borrow<py::object>(reader), gate), metres_per_unit, {}});
  });
  return blocks;
}

std::function<ScanBlocks(const ForeignScan&)> foreignReader(const std::shared_ptr<PythonGate>& gate) {
  const Shared open = shared(py::module_::import("tank_datum._foreign").attr("open_blocks"), gate);
  return [gate, open](const ForeignScan& scan) {
    ScanBlocks blocks;
    Reader reader{gate, {}, scan.metres_per_unit, scan.path};
    reader.enter([&] {
      const py::object path = py::module_::import("os").attr("fsdecode")(py::bytes(scan.path));
      reader.object = shared(py::handle(open.get())(path, scan.format, scan.las_classes), gate);
      blocks = blocksOf(reader);
    });
    return blocks;
  };
}

}  // namespace tank_datum::python
