#include "options.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "core/length_units.h"
#include "core/units.h"
#include "setups/agreement.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

/// One keyword: how it is read from the options and how it is put into them.
struct Keyword {
  const char* name;
  std::function<py::object(const Options&)> get;
  std::function<void(Options&, const py::handle&)> set;
};

template <typename Value, typename Place>
Keyword plain(const char* name, Place place) {
  return {name, [place](const Options& o) { return py::cast(Value(place(const_cast<Options&>(o)))); },
          [place](Options& o, const py::handle& value) { place(o) = value.cast<Value>(); }};
}

template <typename Place>
Keyword degrees(const char* name, Place place) {
  return {name, [place](const Options& o) { return py::cast(toDegrees(place(const_cast<Options&>(o)))); },
          [place](Options& o, const py::handle& value) { place(o) = value.cast<double>() * kPi / 180.0; }};
}

template <typename Place>
Keyword arcSeconds(const char* name, Place place) {
  return {name, [place](const Options& o) { return py::cast(toArcSeconds(place(const_cast<Options&>(o)))); },
          [place](Options& o, const py::handle& value) { place(o) = value.cast<double>() / toArcSeconds(1.0); }};
}

/// A name out of a few.
template <typename Value>
Value named(const char* keyword, const py::handle& value, const std::vector<Value>& values) {
  const auto name = value.cast<std::string>();
  std::string known;
  for (const Value v : values) {
    if (name == nameOf(v)) return v;
    known += (known.empty() ? "" : " or ") + std::string(nameOf(v));
  }
  throw Error(Error::Kind::Option, "options", keyword, name, known);
}

Keyword method() {
  return {"method", [](const Options& o) { return py::cast(nameOf(o.datum.method)); },
          [](Options& o, const py::handle& value) {
            o.datum.method = named<Method>("method", value, {Method::Refined, Method::Paper});
          }};
}

Keyword search() {
  return {"search", [](const Options& o) { return py::cast(nameOf(o.datum.normals.search)); },
          [](Options& o, const py::handle& value) {
            o.datum.normals.search = named<SearchEngine>("search", value, {SearchEngine::Flann, SearchEngine::Buckets});
          }};
}

Keyword service() {
  return {"service", [](const Options& o) { return py::cast(nameOf(o.datum.analysis.facts.service)); },
          [](Options& o, const py::handle& value) {
            o.datum.analysis.facts.service =
                named<Service>("service", value, {Service::New, Service::Rebuilt, Service::InService});
          }};
}

Keyword tank() {
  return {"tank", [](const Options&) { return py::object(py::none()); },
          [](Options& o, const py::handle& value) {
            if (value.is_none()) return;
            const auto [x, y, radius] = value.cast<std::tuple<double, double, double>>();
            o.datum.tank = Circle{{x, y}, radius};
          }};
}

/// A figure that may not be known.
template <typename Place>
Keyword fact(const char* name, Place place) {
  return {
      name,
      [place](const Options& o) {
        const double value = place(const_cast<Options&>(o));
        return std::isnan(value) ? py::object(py::none()) : py::cast(value);
      },
      [place](Options& o, const py::handle& value) { place(o) = value.is_none() ? kUnknown : value.cast<double>(); }};
}

/// A word that may not be known.
template <typename Place>
Keyword word(const char* name, Place place) {
  return {name,
          [place](const Options& o) {
            const std::string& text = place(const_cast<Options&>(o));
            return text.empty() ? py::object(py::none()) : py::cast(text);
          },
          [place](Options& o, const py::handle& value) {
            place(o) = value.is_none() ? std::string() : value.cast<std::string>();
          }};
}

Keyword limits() {
  return {"limits", [](const Options&) { return py::object(py::none()); },
          [](Options& o, const py::handle& value) {
            if (value.is_none()) return;
            o.datum.analysis.limits_file = py::str(value).cast<std::string>();
            o.datum.analysis.limits = readLimits(o.datum.analysis.limits_file);
          }};
}

Keyword units() {
  return {"units", [](const Options& o) { return py::cast(o.units); },
          [](Options& o, const py::handle& value) {
            o.units = value.cast<std::string>();
            if (kUnits.count(o.units) == 0) {
              throw Error(Error::Kind::Option, "options", "units", o.units, "m, mm, ft or in");
            }
          }};
}

Keyword baseline() {
  return {"baseline", [](const Options& o) { return py::cast(o.baseline); },
          [](Options& o, const py::handle& value) {
            o.baseline = py::module_::import("os").attr("fspath")(value).cast<std::string>();
          }};
}

Keyword removal() {
  return {"remove", [](const Options& o) { return py::cast(nameOf(o.movement.removal)); },
          [](Options& o, const py::handle& value) {
            o.movement.removal = named<Removal>("remove", value, {Removal::Nothing, Removal::Mean, Removal::Tilt});
          }};
}

Keyword badSetups() {
  return {
      "bad_setups", [](const Options& o) { return py::cast(nameOf(o.datum.setups.bad)); },
      [](Options& o, const py::handle& value) {
        o.datum.setups.bad = named<BadSetups>("bad_setups", value, {BadSetups::Free, BadSetups::Drop, BadSetups::Keep});
      }};
}

/// A file of rows name,x,y,z in metres, or a dictionary of them.
Keyword setupOrigins() {
  return {"setup_origins", [](const Options&) { return py::object(py::none()); },
          [](Options& o, const py::handle& value) {
            if (value.is_none()) return;
            if (!py::isinstance<py::dict>(value)) {
              o.datum.setups.origins = readSetupOrigins(py::str(value).cast<std::string>());
              return;
            }
            for (const auto& [name, place] : value.cast<std::map<std::string, std::array<double, 3>>>()) {
              o.datum.setups.origins[name] = Eigen::Vector3d(place[0], place[1], place[2]);
            }
          }};
}

const std::vector<Keyword>& keywords() {
  static const std::vector<Keyword> all = {
      method(),
      plain<int>(
          "k", [](Options & o) -> auto& { return o.datum.normals.k; }),
      degrees(
          "angle_deg", [](Options & o) -> auto& { return o.datum.growing.angle; }),
      plain<double>(
          "centre_tolerance", [](Options & o) -> auto& { return o.datum.centre_filter.tolerance; }),
      plain<int>(
          "control_points", [](Options & o) -> auto& { return o.datum.spline.control_points; }),
      search(),
      plain<int>(
          "stations", [](Options & o) -> auto& { return o.datum.stations.count; }),
      degrees(
          "zero_azimuth_deg", [](Options & o) -> auto& { return o.datum.stations.zero_azimuth; }),
      plain<bool>(
          "clockwise", [](Options & o) -> auto& { return o.datum.stations.clockwise; }),
      plain<std::vector<double>>(
          "heights", [](Options & o) -> auto& { return o.datum.shell.heights; }),
      plain<double>(
          "height_step", [](Options & o) -> auto& { return o.datum.shell.step; }),
      tank(),
      plain<int>(
          "pick", [](Options & o) -> auto& { return o.datum.pick; }),
      plain<std::size_t>(
          "search_points", [](Options & o) -> auto& { return o.datum.crop.search_points; }),
      plain<std::size_t>(
          "fit_points", [](Options & o) -> auto& { return o.datum.crop.fit_points; }),
      plain<double>(
          "setup_error", [](Options & o) -> auto& { return o.datum.setups.error; }),
      arcSeconds(
          "setup_tilt_arcsec", [](Options & o) -> auto& { return o.datum.setups.tilt; }),
      badSetups(),
      setupOrigins(),
      plain<double>(
          "min_radius", [](Options & o) -> auto& { return o.datum.locate.min_radius; }),
      units(),
      fact(
          "height", [](Options & o) -> auto& { return o.datum.analysis.facts.height; }),
      fact(
          "yield_mpa", [](Options & o) -> auto& { return o.datum.analysis.facts.yield; }),
      fact(
          "modulus_mpa", [](Options & o) -> auto& { return o.datum.analysis.facts.modulus; }),
      word(
          "roof", [](Options & o) -> auto& { return o.datum.analysis.facts.roof; }),
      word(
          "foundation", [](Options & o) -> auto& { return o.datum.analysis.facts.foundation; }),
      service(),
      plain<int>(
          "classic_points", [](Options & o) -> auto& { return o.datum.analysis.classic_points; }),
      limits(),
      baseline(),
      removal(),
      plain<double>(
          "registration_error", [](Options & o) -> auto& { return o.movement.registration_error; }),
      arcSeconds(
          "registration_tilt_arcsec", [](Options & o) -> auto& { return o.movement.registration_tilt; }),
      degrees(
          "azimuth_offset_deg", [](Options & o) -> auto& { return o.movement.azimuth_offset; }),
      plain<bool>(
          "estimate_azimuth_offset", [](Options & o) -> auto& { return o.movement.estimate_offset; }),
      degrees(
          "correlation_deg", [](Options & o) -> auto& { return o.movement.correlation; }),
      plain<double>(
          "radius_difference", [](Options & o) -> auto& { return o.movement.radius_difference; }),
      plain<double>(
          "centre_distance", [](Options & o) -> auto& { return o.movement.centre_distance; }),
      plain<int>(
          "threads", [](Options & o) -> auto& { return o.datum.threads; }),
  };
  return all;
}

}  // namespace

double Options::metresPerUnit() const { return kUnits.at(units); }

Options optionsFrom(const py::dict& given) {
  Options options;
  for (const auto& [name, value] : given) {
    const auto text = name.cast<std::string>();
    const Keyword* found = nullptr;
    for (const Keyword& keyword : keywords()) {
      if (text == keyword.name) found = &keyword;
    }
    if (!found) throw py::type_error("extract_datum() got an unexpected keyword argument '" + text + "'");
    try {
      found->set(options, value);
    } catch (const py::cast_error&) {
      const auto shown = py::repr(value).cast<std::string>();
      throw py::type_error(text + " = " + shown + ", expected the type of its default");
    }
  }
  return options;
}

py::dict defaults() {
  py::dict all;
  for (const Keyword& keyword : keywords()) all[keyword.name] = keyword.get({});
  return all;
}

}  // namespace tank_datum::python
