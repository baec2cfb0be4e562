#include <pybind11/stl.h>

#include "core/refusal.h"
#include "core/units.h"
#include "fit/curve_comparison.h"
#include "movement/movement.h"
#include "movement/trend.h"
#include "result.h"
#include "tank_datum/limits/limits.h"
#include "values.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

py::list compareTheCurves(const py::array_t<double, py::array::c_style | py::array::forcecast>& line, int points,
                          int degree) {
  LinePoints places;
  const auto rows = line.unchecked<2>();
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) places.emplace_back(rows(i, 0), rows(i, 1));
  CurveOptions options;
  options.points = points;
  options.degree = degree;
  py::list figures;
  for (const CurveFigures& c : compareCurves(places, options)) {
    py::dict figure;
    figure["kind"] = nameOf(c.kind);
    figure["rms"] = c.rms;
    figure["largest"] = c.largest;
    figure["overshoot"] = c.overshoot;
    figures.append(figure);
  }
  return figures;
}

py::object knownOr(double value) { return std::isfinite(value) ? py::object(py::float_(value)) : py::none(); }

py::dict limitOf(const Limit& limit) {
  py::dict powers, made;
  for (const auto& [letter, power] : limit.formula.powers) powers[py::str(std::string(1, letter))] = power;
  made["code"] = limit.code;
  made["clause"] = limit.clause;
  made["name"] = limit.name;
  made["quantity"] = limit.quantity;
  made["judged"] = limit.judged;
  made["factor"] = limit.formula.factor;
  made["powers"] = powers;
  made["at_most"] = knownOr(limit.at_most);
  made["unit"] = limit.unit;
  made["diameter_from"] = limit.diameter.from;
  made["diameter_to"] = knownOr(limit.diameter.to);
  made["roof"] = limit.roof.empty() ? py::object(py::none()) : py::str(limit.roof);
  made["foundation"] = limit.foundation.empty() ? py::object(py::none()) : py::str(limit.foundation);
  made["service"] = limit.service.empty() ? py::object(py::none()) : py::str(limit.service);
  made["trust"] = limit.trust;
  made["citation"] = limit.citation;
  return made;
}

py::list limits(const std::string& path) {
  py::list all;
  for (const Limit& limit : path.empty() ? standardLimits() : readLimits(path)) all.append(limitOf(limit));
  return all;
}

}  // namespace

py::array movementTable(const Movement& movement) {
  const auto& all = movement.stations;
  return table(all.size(), {numbers("azimuth_deg", [&](std::size_t i) { return toDegrees(all[i].azimuth); }),
                            numbers("direction_deg", [&](std::size_t i) { return toDegrees(all[i].direction); }),
                            numbers("dz", [&](std::size_t i) { return all[i].dz; }),
                            numbers("sigma", [&](std::size_t i) { return all[i].sigma; }),
                            numbers("lod95", [&](std::size_t i) { return all[i].lod95(); }),
                            truths("significant", [&](std::size_t i) { return all[i].significant; })});
}

py::array trendTable(const std::vector<StationHistory>& histories) {
  return table(histories.size(),
               {numbers("azimuth_deg", [&](std::size_t i) { return toDegrees(histories[i].azimuth); }),
                numbers("rate", [&](std::size_t i) { return histories[i].rate; }),
                numbers("sigma", [&](std::size_t i) { return histories[i].sigma_rate; }),
                numbers("lod95", [&](std::size_t i) { return histories[i].lod95(); }),
                truths("significant", [&](std::size_t i) { return histories[i].significant; })});
}

void addStudies(py::module_& module) {
  module.def("compare_curves", &compareTheCurves);
  module.def("limits", &limits);
  module.def("limits_text", [] { return standardLimitsText(); });
  module.def("year_of", py::overload_cast<const std::string&>(&yearOf));
}

}  // namespace tank_datum::python
