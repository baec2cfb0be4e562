#include <pybind11/stl.h>

#include <cstring>

#include "command.h"
#include "io/scan_format.h"
#include "job.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

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

py::array edgePoints(const Datum& datum) {
  py::array_t<double> points({datum.edge_points.size(), std::size_t{3}});
  auto at = points.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    const Eigen::Vector3d p = datum.edge_points[static_cast<std::size_t>(i)] + datum.origin;
    for (int c = 0; c < 3; ++c) at(i, c) = p[c];
  }
  return std::move(points);
}

py::dict extract(const std::vector<std::string>& paths, const py::list& arrays, const py::dict& keywords,
                 const py::object& progress) {
  Points3 points{paths, {}};
  for (const py::handle& array : arrays) points.arrays.push_back(pointsIn(array));
  const auto tell = [&](const std::string& stage) {
    if (!progress.is_none()) progress(stage);
  };
  const Result result = runJob(std::move(points), optionsFrom(keywords), tell);
  py::dict made;
  made["json"] = datumJson(result.datum, result.provenance);
  made["csv"] = stationsCsv(result.datum);
  made["summary"] = summary(result.datum);
  made["edge_points"] = edgePoints(result.datum);
  return made;
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of tank_datum.";
  module.attr("__version__") = kVersion;
  static const py::object option_error =
      py::exception<Error>(module, "OptionError", PyExc_ValueError);  // NOLINT: lives as long as the module
  static const py::object file_error = py::exception<Error>(module, "FileError", PyExc_OSError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const bool option = error.kind() == Error::Kind::Option;
      PyErr_SetString((option ? option_error : file_error).ptr(), error.what());
    }
  });
  module.def("extract", &extract);
  module.def("run_command", &runCommand);
  module.def("stop_command_by", &stopCommandBy);
  module.def("foreign_format", &foreignFormatOf);
  module.def("defaults", &defaults);
  module.def("keyword_help", &keywordHelp);
}

}  // namespace tank_datum::python
