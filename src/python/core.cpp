#include <pybind11/stl.h>

#include <cstring>
#include <map>

#include "command.h"
#include "core/plain_text.h"
#include "core/units.h"
#include "foreign.h"
#include "io/e57_pages.h"
#include "io/scan_format.h"
#include "job.h"
#include "las_block.h"
#include "report/section_json.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"
#include "values.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// An array as it is when it holds points; nothing is copied or converted.
py::array pointsIn(const py::handle& given) {
  const auto array = py::array::ensure(given);
  const bool fits = array && array.ndim() == 2 && array.shape(1) == 3 && array.dtype().kind() == 'f' &&
                    (array.itemsize() == 4 || array.itemsize() == 8) && array.dtype().byteorder() != '>';
  if (fits) return array;
  PyErr_Clear();
  throw py::type_error("points = " + py::repr(py::type::of(given)).cast<std::string>() +
                       ", expected an array of shape (n, 3) in float32 or float64, or the path of a scan");
}

/// What a function of the package asks for.
Task::Wanted wantedBy(const std::string& function) {
  static const std::map<std::string, Task::Wanted> all = {{"extract_datum", Task::Wanted::Datum},
                                                          {"extract_datums", Task::Wanted::Datums},
                                                          {"find_tanks", Task::Wanted::Tanks},
                                                          {"read_levelling", Task::Wanted::Levelling}};
  return all.at(function);
}

/// A tank that the search found, in the scan's own frame.
py::dict tankDict(const Tank& tank, const Eigen::Vector3d& origin) {
  py::dict made;
  made["center"] = py::make_tuple(tank.circle.center.x() + origin.x(), tank.circle.center.y() + origin.y());
  made["radius"] = tank.circle.radius;
  made["rms"] = tank.rms;
  made["coverage_deg"] = toDegrees(tank.coverage);
  made["height"] = tank.height;
  made["side"] = tank.side == Side::Inside ? "inside" : "outside";
  made["foot"] = tank.foot.valid() ? py::object(py::float_(tank.foot.coefficients[0] + origin.z())) : py::none();
  made["has_foundation"] = tank.has_foundation;
  return made;
}

/// Runs what a function of the package asks for; what it gives are Results, or dicts of tanks.
/// @param given  what of the task is no option: `blocks`, `levelling`, `diameter`, `baseline_json`
py::list run(const std::string& function, const std::vector<std::string>& paths, const py::list& arrays,
             const py::dict& keywords, const py::dict& given, const py::object& progress) {
  Task task;
  task.wanted = wantedBy(function);
  task.points.paths = paths;
  for (const py::handle& array : arrays) task.points.arrays.push_back(pointsIn(array));
  task.options = optionsFrom(keywords, function);
  task.options.all = task.wanted == Task::Wanted::Datums;
  task.options.datum.refine.profile_points = kProfilePoints;
  if (given.contains("blocks")) task.points.blocks = given["blocks"];
  if (given.contains("baseline_json")) task.baseline_json = given["baseline_json"].cast<std::string>();
  if (given.contains("levelling")) task.options.levelling = given["levelling"].cast<std::string>();
  if (given.contains("diameter")) task.options.diameter = given["diameter"].cast<double>();
  Found found = runJob(std::move(task), [&](const Event& event) {
    if (!progress.is_none()) progress(event.stage, event.rows, event.total, event.begins);
  });
  py::list made;
  for (Result& result : found.results) made.append(py::cast(std::move(result)));
  for (const Tank& tank : found.tanks) made.append(tankDict(tank, found.origin));
  return made;
}

/// Raises the package's exception for a refused option or a file, with all parts of the message.
void raise(const Error& error) {
  const char* kind = error.kind() == Error::Kind::Option ? "OptionError" : "FileError";
  const py::object type = py::module_::import("tank_datum._errors").attr(kind);
  const Refusal& refused = error.refused();
  const auto told = py::make_tuple(textFrom(error.what()), textFrom(error.stage()), textFrom(refused.name),
                                   textFrom(refused.value), textFrom(refused.expected));
  py::object made = type(*told);
  if (error.kind() == Error::Kind::File && !refused.file.empty()) {
    made.attr("filename") = py::module_::import("os").attr("fsdecode")(py::bytes(refused.file));
  }
  if (refused.system_error != 0) made.attr("errno") = refused.system_error;
  PyErr_SetObject(type.ptr(), made.ptr());
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of tank_datum.";
  module.attr("__version__") = kVersion;
  module.def("system_text", [](int number) { return systemText(number); });
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
  addResult(module);
  addStages(module);
  addLasBlock(module);
  addStudies(module);
  addPrograms(module);
  module.def("run", &run);
  module.def("run_command", &runCommand);
  module.def("stop_command_by", &stopCommandBy);
  module.def("foreign_format", &foreignFormatOf);
  module.def("e57_pages_are_sound", [](const py::bytes& path, std::uint64_t first, std::uint64_t count) {
    const std::string bytes = path;
    const py::gil_scoped_release unlocked;
    return e57PagesAreSound(bytes, {first, count});
  });
  module.def("defaults", &defaults);
  module.def("keywords_of_scans", &keywordsOfScans);
  module.def("keyword_help", &keywordHelp);
}

}  // namespace tank_datum::python
