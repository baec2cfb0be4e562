#include "values.h"

#include <pybind11/stl.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace py = pybind11;

namespace tank_datum::python {
namespace {

template <typename Value>
std::function<void(char*, std::size_t)> writer(std::function<Value(std::size_t)> value) {
  return [value = std::move(value)](char* at, std::size_t row) {
    const Value v = value(row);
    std::memcpy(at, &v, sizeof v);
  };
}

}  // namespace

py::object textFrom(const std::string& text) {
  PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(decoded);
}

py::object toPython(const nlohmann::ordered_json& json) {
  if (json.is_null()) return py::none();
  if (json.is_boolean()) return py::bool_(json.get<bool>());
  if (json.is_number_unsigned()) return py::int_(json.get<std::uint64_t>());
  if (json.is_number_integer()) return py::int_(json.get<std::int64_t>());
  if (json.is_number_float()) return py::float_(json.get<double>());
  if (json.is_string()) return textFrom(json.get_ref<const std::string&>());
  if (json.is_array()) {
    py::list list;
    for (const auto& value : json) list.append(toPython(value));
    return std::move(list);
  }
  py::dict dict;
  for (const auto& [key, value] : json.items()) dict[textFrom(key)] = toPython(value);
  return std::move(dict);
}

Column numbers(const std::string& name, std::function<double(std::size_t row)> value) {
  const auto finite = [value = std::move(value)](std::size_t row) {
    const double v = value(row);
    return std::isfinite(v) ? v : std::numeric_limits<double>::quiet_NaN();
  };
  return {name, "f8", writer<double>(finite)};
}

Column truths(const std::string& name, std::function<bool(std::size_t row)> value) {
  return {name, "?", writer<bool>(std::move(value))};
}

Column words(const std::string& name, std::size_t width, std::function<std::string(std::size_t row)> value) {
  const auto write = [width, value = std::move(value)](char* at, std::size_t row) {
    const std::string word = value(row);
    for (std::size_t i = 0; i < width; ++i) {  // UCS-4, filled with zeros
      const std::uint32_t letter = i < word.size() ? static_cast<unsigned char>(word[i]) : 0U;
      std::memcpy(at + i * sizeof letter, &letter, sizeof letter);
    }
  };
  return {name, "U" + std::to_string(width), write};
}

Column counter(const std::string& name) {
  return {name, "i8", writer<std::int64_t>([](std::size_t row) { return static_cast<std::int64_t>(row); })};
}

py::array table(std::size_t rows, const std::vector<Column>& columns) {
  py::list fields;
  std::vector<std::size_t> offsets;
  std::size_t width = 0;
  for (const Column& column : columns) {
    fields.append(py::make_tuple(column.name, column.type));
    offsets.push_back(width);
    width += static_cast<std::size_t>(py::dtype(column.type).itemsize());
  }
  py::array made(py::dtype::from_args(fields), std::vector<py::ssize_t>{static_cast<py::ssize_t>(rows)});
  char* data = static_cast<char*>(made.mutable_data());
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].write(data + row * width + offsets[c], row);
  }
  return made;
}

py::array_t<double> matrix(std::size_t rows, std::size_t columns,
                           const std::function<double(std::size_t row, std::size_t column)>& value) {
  py::array_t<double> made({rows, columns});
  double* at = made.mutable_data();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) *at++ = value(row, column);
  }
  return made;
}

}  // namespace tank_datum::python
