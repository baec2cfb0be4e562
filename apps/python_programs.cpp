// What the Python package does as the programs do: result folders, comparisons with their files, simulated scans.
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/refusal.h"
#include "core/units.h"
#include "movement/epoch.h"
#include "movement/movement.h"
#include "movement/trend.h"
#include "movement_files.h"
#include "options/option_table.h"
#include "python/interrupt.h"
#include "python/options.h"
#include "python/result.h"
#include "python/values.h"
#include "results/manifest.h"
#include "results/output_file.h"
#include "results/result_folder.h"
#include "results/stop_signals.h"
#include "synth/output.h"
#include "synth/scanner.h"
#include "synth/scene_file.h"
#include "synth/truth.h"
#include "tank_datum/core/error.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// Writes files into a result folder, whole or not at all; signals that end the process wait for that.
void saveFiles(const std::string& folder, const std::map<std::string, py::bytes>& files, const std::string& program) {
  const results::SignalsWait waiting;
  ResultFolder to(folder, program);
  for (const auto& [name, content] : files) {
    const std::string path = to.stage("") + "/" + name;
    std::ofstream out(path, std::ios::binary);
    out << std::string_view(content);
    out.close();
    if (!out) throw Error(Error::Kind::File, "report", path, "not written", "a writable folder with room");
  }
  to.commit();
}

/// Writes a report's page, whole or not at all.
void savePage(const std::string& path, const std::string& page) {
  const results::SignalsWait waiting;
  OutputFile file(path, isReportPage(), results::kDatumProgram);
  file.write(page);
  file.commit();
}

/// A survey in memory: its name, the text of its datum.json and the text's SHA-256.
using Survey = std::tuple<std::string, std::string, std::string>;

/// Surveys compared with the first; no dates, or one each.
class Compared {
 public:
  Compared(const std::vector<Survey>& surveys, std::vector<std::string> dates, const py::dict& keywords) {
    comparison_.dates = std::move(dates);
    comparison_.options = movementOptionsFrom(keywords);
    std::vector<Epoch> epochs;
    for (const auto& [name, text, hash] : surveys) {
      comparison_.names.push_back(name);
      comparison_.hashes.push_back(hash);
      epochs.push_back(epochIn(text, name));
    }
    comparison_.movements = compareWithFirst(epochs, comparison_.options);
    if (valid()) followOverTime(comparison_, std::move(epochs));
  }

  bool valid() const {
    const auto& all = comparison_.movements;
    return std::all_of(all.begin(), all.end(), [](const Movement& m) { return m.valid(); });
  }
  std::string json() const { return movementsJson(comparison_); }
  py::object record() const { return toPython(nlohmann::ordered_json::parse(json())); }
  py::array trend() const { return trendTable(comparison_.histories); }
  py::list movements() const {
    py::list all;
    for (const Movement& m : comparison_.movements) all.append(movementTable(m));
    return all;
  }
  void save(const std::string& folder) const {
    const results::SignalsWait waiting;
    ResultFolder to(folder, results::kCompareProgram);
    writeMovement(to, comparison_);
    to.commit();
  }

 private:
  Comparison comparison_;
};

/// A scan being simulated, into a file or into memory.
struct Simulated {
  synth::Command command;
  std::vector<double> rows;
  std::vector<std::uint16_t> setups;
  synth::ScanSummary summary;
  nlohmann::ordered_json truth;

  void scan() {
    const synth::Scene scene(command.scene);
    truth = synth::toJson(synth::truthOf(scene, scene.options().truth_stations));
    if (!command.output.empty()) {
      summary = synth::writeScan(scene, command);
      return;
    }
    const auto keep = [this](std::size_t station, const synth::Rows& more) {
      rows.insert(rows.end(), more.begin(), more.end());
      setups.resize(rows.size() / 4, static_cast<std::uint16_t>(station));
    };
    summary = synth::scanScene(scene, keep, command.threads);
  }
};

/// A scene as JSON text; with `output` written as tank_datum_synth does, else as arrays.
py::dict simulate(const std::string& scene_json, const std::string& output, int threads) {
  DatumOptions options;
  options.threads = threads;
  refuseFirst(firstError(options));
  const auto scan = std::make_shared<Simulated>();
  nlohmann::ordered_json read = nlohmann::ordered_json::parse(scene_json);
  scan->command.scene = synth::sceneFromJson(read);
  scan->command.threads = static_cast<unsigned>(threads);
  scan->command.output = output;
  scan->command.truth = std::filesystem::path(output).replace_extension(".truth.json").string();
  runInterruptibly([scan] { scan->scan(); });
  py::dict made;
  made["truth"] = toPython(scan->truth);
  made["rays"] = scan->summary.rays;
  if (!output.empty()) return made;
  const auto& rows = scan->rows;
  const auto& setups = scan->setups;
  made["points"] = matrix(setups.size(), 3, [&](std::size_t row, std::size_t c) { return rows[4 * row + c]; });
  py::array_t<double> intensity(static_cast<py::ssize_t>(setups.size()));
  for (std::size_t i = 0; i < setups.size(); ++i) intensity.mutable_data()[i] = rows[4 * i + 3];
  made["intensity"] = intensity;
  made["setups"] = py::array_t<std::uint16_t>(static_cast<py::ssize_t>(setups.size()), setups.data());
  return made;
}

}  // namespace

void addPrograms(py::module_& module) {
  py::class_<Compared>(module, "Compared")
      .def(py::init<const std::vector<Survey>&, std::vector<std::string>, const py::dict&>())
      .def("valid", &Compared::valid)
      .def("json", &Compared::json)
      .def("record", &Compared::record)
      .def("trend", &Compared::trend)
      .def("movements", &Compared::movements)
      .def("save", &Compared::save);
  module.def("save_files", [](const std::string& folder, const std::map<std::string, py::bytes>& files) {
    saveFiles(folder, files, results::kDatumProgram);
  });
  module.def("save_page", [](const std::string& path, const py::bytes& page) { savePage(path, page); });
  module.def("settle", [](const std::string& path) { settleToRead(path, results::kDatumProgram); });
  module.def("simulate", &simulate);
}

}  // namespace tank_datum::python
