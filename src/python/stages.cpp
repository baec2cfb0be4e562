#include <pybind11/stl.h>

#include <memory>

#include "core/refusal.h"
#include "core/units.h"
#include "interrupt.h"
#include "options/option_table.h"
#include "result.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/search/estimate_normals.h"
#include "values.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

using Coordinates = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Whole = py::array_t<std::int32_t, py::array::c_style | py::array::forcecast>;
using Singles = py::array_t<float, py::array::c_style | py::array::forcecast>;

void requireShape(const char* name, const py::array& array, py::ssize_t columns) {
  if (array.ndim() == 2 && (columns == 0 || array.shape(1) == columns)) return;
  throw py::value_error(std::string(name) + ", shape " + py::str(array.attr("shape")).cast<std::string>() +
                        ", expected (n, " + (columns == 0 ? "k" : std::to_string(columns)) + ")");
}

/// Finite points, moved so that the first is at zero: the stages work near the origin.
Points pointsFrom(const Coordinates& given) {
  requireShape("points", given, 3);
  const auto rows = given.unchecked<2>();
  Points points;
  points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    points.emplace_back(rows(i, 0) - rows(0, 0), rows(i, 1) - rows(0, 1), rows(i, 2) - rows(0, 2));
    if (points.back().allFinite()) continue;
    throw Error(Error::Kind::Option, "stages", "row " + std::to_string(i) + " of points", "not finite",
                "finite coordinates: the stages number points as the array does");
  }
  return points;
}

/// The options of one stage, from the keywords of the table of options.
DatumOptions optionsWith(const std::function<void(DatumOptions&)>& set) {
  DatumOptions options;
  set(options);
  refuseFirst(firstError(options));
  return options;
}

SearchEngine engineOf(const std::string& name) {
  for (const SearchEngine engine : {SearchEngine::Flann, SearchEngine::Buckets}) {
    if (name == nameOf(engine)) return engine;
  }
  throw Error(Error::Kind::Option, "options", "search", name, "flann or buckets");
}

Whole indexArray(const std::vector<std::int32_t>& indices) {
  return Whole(static_cast<py::ssize_t>(indices.size()), indices.data());
}

py::tuple normals(const Coordinates& given, int k, const std::string& search, int threads) {
  const DatumOptions options = optionsWith([&](DatumOptions& o) {
    o.normals.k = k;
    o.normals.search = engineOf(search);
    o.threads = threads;
  });
  const auto found = std::make_shared<Normals>();
  runInterruptibly([=, points = pointsFrom(given)] { *found = estimateNormals(points, options.normals, threads); });
  Whole neighbours({static_cast<py::ssize_t>(found->size()), static_cast<py::ssize_t>(k)});
  std::copy(found->neighbours.begin(), found->neighbours.end(), neighbours.mutable_data());
  py::array_t<float> directions({static_cast<py::ssize_t>(found->size()), py::ssize_t{3}});
  float* at = directions.mutable_data();
  for (const Eigen::Vector3f& n : found->normals) at = std::copy(n.data(), n.data() + 3, at);
  return py::make_tuple(neighbours, directions);
}

void requireWithin(const std::string& name, const Whole& indices, std::size_t points) {
  const std::int32_t* at = indices.data();
  for (py::ssize_t i = 0; i < indices.size(); ++i) {
    if (at[i] >= 0 && static_cast<std::size_t>(at[i]) < points) continue;
    throw Error(Error::Kind::Option, "stages", name, std::to_string(at[i]),
                "one of the " + std::to_string(points) + " points, counted from 0");
  }
}

Whole candidates(const Whole& neighbours, const Singles& directions, double angle_deg, int threads) {
  requireShape("neighbours", neighbours, 0);
  requireShape("normals", directions, 3);
  const DatumOptions options = optionsWith([&](DatumOptions& o) {
    o.growing.angle = toRadians(angle_deg);
    o.threads = threads;
  });
  Normals given;
  given.k = static_cast<int>(neighbours.shape(1));
  const auto rows = static_cast<std::size_t>(directions.shape(0));
  if (neighbours.shape(0) != directions.shape(0)) {
    throw Error(Error::Kind::Option, "stages", "rows of neighbours", std::to_string(neighbours.shape(0)),
                "as many as normals, " + std::to_string(rows));
  }
  requireWithin("neighbours", neighbours, rows);
  given.neighbours.assign(neighbours.data(), neighbours.data() + neighbours.size());
  for (std::size_t i = 0; i < rows; ++i) given.normals.emplace_back(directions.data() + 3 * i);
  const auto found = std::make_shared<std::vector<std::int32_t>>();
  runInterruptibly([=, given = std::move(given)] { *found = growCandidates(given, options.growing, threads); });
  return indexArray(*found);
}

py::dict edgePoints(const Coordinates& given, const Whole& chosen, const std::optional<std::array<double, 3>>& tank,
                    double tolerance) {
  const DatumOptions options = optionsWith([&](DatumOptions& o) {
    o.centre_filter.tolerance = tolerance;
    if (tank) o.tank = Circle{{(*tank)[0], (*tank)[1]}, (*tank)[2]};
  });
  const Points points = pointsFrom(given);
  requireWithin("candidates", chosen, points.size());
  const Eigen::Vector2d origin =
      points.empty() ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(given.at(0, 0), given.at(0, 1));
  std::optional<Circle> start;
  if (tank) start = Circle{Eigen::Vector2d((*tank)[0], (*tank)[1]) - origin, (*tank)[2]};
  const std::vector<std::int32_t> among(chosen.data(), chosen.data() + chosen.size());
  const auto found = std::make_shared<EdgePoints>();
  runInterruptibly([=] { *found = filterByCentre(points, among, start, options.centre_filter); });
  const EdgePoints& edge = *found;
  py::dict made;
  made["indices"] = indexArray(edge.indices);
  py::array_t<double> azimuths(static_cast<py::ssize_t>(edge.azimuths.size()));
  for (std::size_t i = 0; i < edge.azimuths.size(); ++i) azimuths.mutable_data()[i] = toDegrees(edge.azimuths[i]);
  made["azimuth_deg"] = azimuths;
  made["center"] = py::make_tuple(edge.circle.center.x() + origin.x(), edge.circle.center.y() + origin.y());
  made["radius"] = edge.circle.radius;
  made["tolerance"] = edge.tolerance;
  return made;
}

}  // namespace

void addStages(py::module_& module) {
  module.def("normals", &normals);
  module.def("candidates", &candidates);
  module.def("edge_points", &edgePoints);
}

}  // namespace tank_datum::python
