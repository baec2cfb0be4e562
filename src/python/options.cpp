#include "options.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "options/option_table.h"
#include "report/identity.h"
#include "tank_datum/core/unknown.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

std::string pathFrom(const py::handle& value) {
  return value.is_none() ? std::string() : py::module_::import("os").attr("fspath")(value).cast<std::string>();
}

/// Puts a Python value where the option keeps it.
struct Put {
  Option& option;
  py::handle value;

  template <typename Plain>
  void operator()(Plain* kept) const {
    *kept = value.cast<Plain>();
  }
  void operator()(double* kept) const { *kept = option.kept(value.cast<double>()); }
  void operator()(std::optional<Circle>* circle) const {
    circle->reset();
    if (value.is_none()) return;
    const auto [x, y, radius] = value.cast<std::tuple<double, double, double>>();
    *circle = Circle{{x, y}, radius};
  }
  void operator()(const Fact& fact) const { *fact.value = value.is_none() ? kUnknown : value.cast<double>(); }
  void operator()(const Path& path) const { *path.path = pathFrom(value); }
  void operator()(const Places& places) const {
    places.places->clear();
    if (!py::isinstance<py::dict>(value)) {
      *places.path = pathFrom(value);
      return;
    }
    for (const auto& [name, at] : value.cast<std::map<std::string, std::array<double, 3>>>()) {
      (*places.places)[name] = Eigen::Vector3d(at[0], at[1], at[2]);
    }
  }
  void operator()(const Choice&) const { option.choose(value.is_none() ? std::string() : value.cast<std::string>()); }
};

/// A value as Python has it; None: not given.
struct Get {
  const Option& option;

  template <typename Plain>
  py::object operator()(const Plain* kept) const {
    return py::cast(*kept);
  }
  py::object operator()(const double* kept) const { return py::cast(option.typed(*kept)); }
  py::object operator()(const std::optional<Circle>* circle) const {
    if (!*circle) return py::none();
    return py::make_tuple((*circle)->center.x(), (*circle)->center.y(), (*circle)->radius);
  }
  py::object operator()(const Fact& fact) const {
    return std::isnan(*fact.value) ? py::object(py::none()) : py::cast(*fact.value);
  }
  py::object operator()(const Path& path) const { return text(*path.path); }
  py::object operator()(const Places& places) const { return text(*places.path); }
  py::object operator()(const Choice& choice) const { return text(choice.get()); }

  static py::object text(const std::string& text) { return text.empty() ? py::object(py::none()) : py::cast(text); }
};

std::vector<Option> keywordsOf(RunOptions& run) {
  std::vector<Option> keywords;
  for (const Option& option : optionsOf(run)) {
    if (option.giver == Giver::All) keywords.push_back(option);
  }
  return keywords;
}

/// Puts keywords where the options keep them.
void put(const std::vector<Option>& options, const py::dict& given, const std::string& function) {
  std::map<std::string, Option> keywords;
  for (const Option& option : options) keywords.emplace(option.name, option);
  for (const auto& [name, value] : given) {
    const auto found = keywords.find(name.cast<std::string>());
    if (found == keywords.end()) {
      throw py::type_error(function + "() got an unexpected keyword argument '" + name.cast<std::string>() + "'");
    }
    try {
      std::visit(Put{found->second, value}, found->second.value);
    } catch (const py::cast_error&) {
      const auto shown = py::repr(value).cast<std::string>();
      throw py::type_error(found->first + " = " + shown + ", expected the type of its default");
    }
  }
}

}  // namespace

RunOptions optionsFrom(const py::dict& given, const std::string& function) {
  RunOptions run;
  put(keywordsOf(run), given, function);
  readFilesOf(run);
  readIdentity(run);
  return run;
}

MovementOptions movementOptionsFrom(const py::dict& given) {
  MovementOptions movement;
  put(movementOptionsOf(movement), given, "compare");
  if (const auto refused = firstError(movement)) throw Error(Error::Kind::Option, "options", *refused);
  return movement;
}

py::dict defaults() {
  RunOptions run;
  py::dict all;
  for (const Option& option : keywordsOf(run)) all[option.name.c_str()] = std::visit(Get{option}, option.value);
  return all;
}

std::string keywordHelp() {
  RunOptions run;
  std::string lines;
  for (const Option& option : keywordsOf(run)) {
    const std::string expected = option.expected().empty() ? "" : " (" + option.expected() + ")";
    const auto value = py::repr(std::visit(Get{option}, option.value)).cast<std::string>();
    lines += "    " + option.name + ": " + option.text() + expected + "; default " + value + "\n";
  }
  return lines;
}

}  // namespace tank_datum::python
