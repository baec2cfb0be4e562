#include "typed_text.h"

#include <charconv>
#include <sstream>

#include "core/length_units.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

Error unreadable(const std::string& flag, const std::string& typed, const std::string& expected) {
  return Error(Error::Kind::Option, "command line", {flag, typed, expected});
}

/// The numbers between commas.
template <typename Number>
std::vector<Number> listFrom(const std::string& flag, const std::string& typed, const char* expected) {
  std::vector<Number> numbers;
  std::istringstream in(typed);
  for (std::string cell; std::getline(in, cell, ',');) {
    std::istringstream text(cell);
    Number number = 0;
    if (!(text >> number) || !(text >> std::ws).eof()) throw unreadable(flag, typed, expected);
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

double lengthFrom(const std::string& flag, const std::string& typed) {
  double value = 0.0;
  const auto read = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  std::string unit(read.ptr, typed.data() + typed.size());
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  const auto known = kUnits.find(unit.empty() ? "m" : unit);
  if (read.ec != std::errc() || known == kUnits.end()) {
    throw unreadable(flag, typed, "a length as 8, 8m, 26.25ft, 315in or 8000mm");
  }
  return value * known->second;
}

Circle circleFrom(const std::string& flag, const std::string& typed) {
  Circle circle;
  char comma = 0, other = 0;
  std::istringstream in(typed);
  in >> circle.center.x() >> comma >> circle.center.y() >> other >> circle.radius;
  if (!in || !(in >> std::ws).eof() || comma != ',' || other != ',') {
    throw unreadable(flag, typed, "X,Y,R in metres");
  }
  return circle;
}

std::vector<double> numbersFrom(const std::string& flag, const std::string& typed) {
  return listFrom<double>(flag, typed, "H,H,... in metres");
}

std::vector<int> codesFrom(const std::string& flag, const std::string& typed) {
  return listFrom<int>(flag, typed, "whole numbers C,C,...");
}

std::vector<std::string> namesFrom(const std::string& flag, const std::string& typed) {
  std::vector<std::string> names;
  std::istringstream in(typed);
  for (std::string cell; std::getline(in, cell, ',');) {
    const std::size_t first = cell.find_first_not_of(' ');
    if (first == std::string::npos) throw unreadable(flag, typed, "names A,B,...");
    names.push_back(cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return names;
}

}  // namespace tank_datum
