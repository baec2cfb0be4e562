#include "typed_text.h"

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
  const std::optional<double> length = lengthOf(typed);
  if (!length) throw unreadable(flag, typed, kLengthWanted);
  return *length;
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
