#include "options.h"

#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "core/length_units.h"
#include "options/option_table.h"
#include "report/identity.h"
#include "tank_datum/core/unknown.h"

namespace py = pybind11;

namespace tank_datum::python {
namespace {

constexpr const char* kNoScan = "none: a levelling survey has no scan";

/// A value in a message of one line.
std::string shown(const py::handle& value) {
  return py::module_::import("tank_datum._errors").attr("short")(value).cast<std::string>();
}

bool isTruth(const py::handle& value) {
  return py::isinstance<py::bool_>(value) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

/// Puts a Python value where the option keeps it.
/// @throws py::cast_error for a value of another type
struct Put {
  Option& option;
  py::handle value;

  template <typename Plain>
  void operator()(Plain* kept) const {
    *kept = value.cast<Plain>();
  }
  void operator()(bool* kept) const {
    if (!isTruth(value)) throw py::cast_error();
    *kept = value.cast<bool>();
  }
  void operator()(int* kept) const { *kept = whole<int>(); }
  void operator()(std::size_t* kept) const { *kept = whole<std::size_t>(); }
  void operator()(double* kept) const { *kept = option.kept(number()); }
  void operator()(std::optional<Circle>* circle) const {
    circle->reset();
    if (value.is_none()) return;
    const auto [x, y, radius] = value.cast<std::tuple<double, double, double>>();
    *circle = Circle{{x, y}, radius};
  }
  void operator()(const Fact& fact) const { *fact.value = value.is_none() ? kUnknown : factGiven(); }
  void operator()(const Path& path) const { *path.path = pathGiven(); }
  void operator()(const Places& places) const {
    places.places->clear();
    if (!py::isinstance<py::dict>(value)) {
      *places.path = pathGiven();
      return;
    }
    if (py::len(value) == 0) throw py::cast_error();
    for (const auto& [name, at] : value.cast<std::map<std::string, std::array<double, 3>>>()) {
      (*places.places)[name] = Eigen::Vector3d(at[0], at[1], at[2]);
    }
  }
  void operator()(const Choice&) const { option.choose(value.is_none() ? std::string() : value.cast<std::string>()); }

  double number() const {
    if (isTruth(value)) throw py::cast_error();
    return value.cast<double>();
  }

  /// Neither a fraction nor a truth value.
  template <typename Integer>
  Integer whole() const {
    if (isTruth(value) || PyIndex_Check(value.ptr()) == 0) throw py::cast_error();
    try {
      return value.cast<Integer>();
    } catch (const py::cast_error&) {  // too large, or below 0
      throw Error(Error::Kind::Option, "options",
                  {option.name, shown(value),
                   option.expected() + ", at most " + std::to_string(std::numeric_limits<Integer>::max())});
    }
  }

  double factGiven() const {
    if (option.unit != Unit::Metres || !py::isinstance<py::str>(value)) return option.given(number());
    const auto typed = value.cast<std::string>();
    const std::optional<double> length = lengthOf(typed);
    if (!length) throw Error(Error::Kind::Option, "options", {option.name, typed, kLengthWanted});
    return *length;
  }

  /// Its bytes, whatever their encoding.
  std::string pathGiven() const {
    if (value.is_none()) return {};
    std::string path;
    try {
      path = py::module_::import("os").attr("fsencode")(value).cast<std::string>();
    } catch (const py::error_already_set& raised) {
      if (raised.matches(PyExc_TypeError)) throw py::cast_error();
      if (!raised.matches(PyExc_UnicodeEncodeError)) throw;
    }
    if (path.empty() || path.find('\0') != std::string::npos) {
      const bool nothing = py::isinstance<py::str>(value) && py::len(value) == 0;
      throw Error(Error::Kind::Option, "options", {option.name, nothing ? "\"\"" : shown(value), "a path, or None"});
    }
    return path;
  }
};

/// What a value of the option is in Python, for messages.
struct TypeWanted {
  const Option& option;

  std::string operator()(const bool*) const { return "True or False"; }
  std::string operator()(const int*) const { return "a whole number"; }
  std::string operator()(const std::size_t*) const { return "a whole number >= 0"; }
  std::string operator()(const double*) const { return "a number"; }
  std::string operator()(const std::vector<double>*) const { return "a list of numbers"; }
  std::string operator()(const std::vector<int>*) const { return "a list of whole numbers"; }
  std::string operator()(const std::vector<std::string>*) const { return "a list of texts"; }
  std::string operator()(const std::optional<Circle>*) const { return "(x, y, radius), or None"; }
  std::string operator()(const Fact&) const {
    return option.unit == Unit::Metres ? std::string(kLengthWanted) + ", or None" : "a number, or None";
  }
  std::string operator()(const Path&) const { return "a path, or None"; }
  std::string operator()(const Places&) const { return "a path, a dict of (x, y, z) by name, or None"; }
  std::string operator()(const Choice& choice) const { return option.expected() + (choice.needed ? "" : ", or None"); }
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
    if (found->second.of_scans && function == "read_levelling") {
      throw Error(Error::Kind::Option, "options", {found->first, shown(value), kNoScan});
    }
    const auto refuse = [&option = found->second, &given_value = value] {
      const std::string wanted = std::visit(TypeWanted{option}, option.value);
      throw py::type_error(option.name + " = " + shown(given_value) + ", expected " + wanted);
    };
    try {
      std::visit(Put{found->second, value}, found->second.value);
    } catch (const py::cast_error&) {
      refuse();
    } catch (const py::error_already_set& raised) {  // an array without a length
      if (!raised.matches(PyExc_TypeError)) throw;
      refuse();
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

py::list keywordsOfScans() {
  RunOptions run;
  py::list names;
  for (const Option& option : keywordsOf(run)) {
    if (option.of_scans) names.append(option.name);
  }
  return names;
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
