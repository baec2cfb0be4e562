#include "result.h"

#include <pybind11/stl.h>

#include "core/units.h"
#include "report/datum_record.h"
#include "values.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

double countOf(const std::optional<std::size_t>& count) { return count ? static_cast<double>(*count) : kUnknown; }

/// The columns of stations.csv.
py::array stationTable(const Datum& datum) {
  const Eigen::Vector3d& o = datum.origin;
  const auto column = [&](const char* name, double (*value)(const Station&, const Eigen::Vector3d&)) {
    return numbers(name, [&, value](std::size_t row) { return value(datum.stations[row], o); });
  };
  using S = const Station&;
  using V = const Eigen::Vector3d&;
  return table(
      datum.stations.size(),
      {counter("station"), column("azimuth_deg", [](S s, V) { return toDegrees(s.azimuth); }),
       column("x", [](S s, V at) { return s.x + at.x(); }), column("y", [](S s, V at) { return s.y + at.y(); }),
       column("z", [](S s, V at) { return s.z + at.z(); }), column("sigma_z", [](S s, V) { return s.sigma_z; }),
       column("radius", [](S s, V) { return s.radius; }), column("sigma_radius", [](S s, V) { return s.sigma_radius; }),
       column("n_shell", [](S s, V) { return countOf(s.n_shell); }),
       column("n_foundation", [](S s, V) { return countOf(s.n_foundation); }),
       words("flag", 12, [&](std::size_t row) { return std::string(nameOf(datum.stations[row].flag)); }),
       column("z_paper", [](S s, V at) { return s.z_paper + at.z(); }),
       column("z_tilt", [](S s, V at) { return s.z_tilt + at.z(); }), column("u", [](S s, V) { return s.u; }),
       column("u_fit", [](S s, V) { return s.u_fit; }), column("curvature", [](S s, V) { return s.curvature; }),
       column("n_setups", [](S s, V) { return countOf(s.n_setups); }),
       column("sigma_setup", [](S s, V) { return s.sigma_setup; }),
       words("reason", 13, [&](std::size_t row) { return std::string(nameOf(datum.stations[row].reason)); })});
}

py::array_t<double> edgePoints(const Datum& datum) {
  return matrix(datum.edge_points.size(), 3, [&](std::size_t row, std::size_t c) {
    const auto axis = static_cast<Eigen::Index>(c);
    return datum.edge_points[row][axis] + datum.origin[axis];
  });
}

/// The columns of shell.csv.
py::array shellTable(const Datum& datum) {
  const auto& points = datum.shell.points;
  const auto column = [&](const char* name, double (*value)(const ShellPoint&)) {
    return numbers(name, [&points, value](std::size_t row) { return value(points[row]); });
  };
  using P = const ShellPoint&;
  return table(
      points.size(),
      {column("azimuth_deg", [](P p) { return toDegrees(p.azimuth); }), column("height", [](P p) { return p.height; }),
       column("radius", [](P p) { return p.radius; }), column("deviation", [](P p) { return p.deviation; }),
       column("sigma", [](P p) { return p.sigma; }), column("n", [](P p) { return static_cast<double>(p.points); }),
       column("offset", [](P p) { return p.offset; })});
}

/// Writes the command's files into a folder that is there.
void writeFiles(const Result& result, const std::string& folder) {
  const py::gil_scoped_release unlocked;
  writeResults(folder, result.datum, result.provenance);
  writeReportPage(folder, reportPage(result.datum, result.provenance));
}

}  // namespace

void addResult(py::module_& module) {
  py::class_<Result>(module, "Result")
      .def("record", [](const Result& r) { return toPython(datumRecord(r.datum, r.provenance)); })
      .def("json", [](const Result& r) { return datumJson(r.datum, r.provenance); })
      .def("summary", [](const Result& r) { return summary(r.datum); })
      .def("stations", [](const Result& r) { return stationTable(r.datum); })
      .def("shell_points", [](const Result& r) { return shellTable(r.datum); })
      .def("edge_points", [](const Result& r) { return edgePoints(r.datum); })
      .def("write", &writeFiles);
}

}  // namespace tank_datum::python
