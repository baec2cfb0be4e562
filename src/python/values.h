#pragma once

#include <pybind11/numpy.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tank_datum::python {

/// Text that is no UTF-8 is mended as in files.
pybind11::object textFrom(const std::string& text);

/// A JSON value as Python has it: dict, list, str, int, float, bool, None.
pybind11::object toPython(const nlohmann::ordered_json& json);

/// A column of a structured array: its name, NumPy's name of its type, and what writes the value of a row.
struct Column {
  std::string name, type;
  std::function<void(char* at, std::size_t row)> write;
};

/// A column of doubles; what is not finite is NaN.
Column numbers(const std::string& name, std::function<double(std::size_t row)> value);
/// A column of truth values.
Column truths(const std::string& name, std::function<bool(std::size_t row)> value);
/// A column of ASCII words, at most `width` characters each.
Column words(const std::string& name, std::size_t width, std::function<std::string(std::size_t row)> value);
/// The column that numbers the rows from 0.
Column counter(const std::string& name);

/// A structured array of shape (rows,).
pybind11::array table(std::size_t rows, const std::vector<Column>& columns);

/// An array of shape (rows, columns) of doubles.
pybind11::array_t<double> matrix(std::size_t rows, std::size_t columns,
                                 const std::function<double(std::size_t row, std::size_t column)>& value);

}  // namespace tank_datum::python
