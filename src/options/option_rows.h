#pragma once

#include <string>
#include <utility>
#include <vector>

#include "options/option.h"

/// What the table of options is written with.
namespace tank_datum::option_rows {

/// One of an enum's values, by the names that nameOf gives them.
template <typename Enum>
Choice choiceOf(Enum& value, const std::vector<Enum>& all) {
  Choice choice;
  for (const Enum one : all) choice.words.emplace_back(nameOf(one));
  choice.get = [&value] { return std::string(nameOf(value)); };
  choice.set = [&value, all](const std::string& word) {
    for (const Enum one : all) {
      if (word == nameOf(one)) value = one;
    }
  };
  return choice;
}

inline Choice choiceOf(std::string& value, std::vector<std::string> words) {
  Choice choice;
  choice.words = std::move(words);
  choice.get = [&value] { return value; };
  choice.set = [&value](const std::string& word) { value = word; };
  return choice;
}

/// The same, or none of them.
inline Choice anyOf(std::string& value, std::vector<std::string> words) {
  Choice choice = choiceOf(value, std::move(words));
  choice.needed = false;
  return choice;
}

struct Table {
  std::vector<Option> rows;
  std::string topic;
  bool of_scans = false;

  Option& add(const std::string& name, const std::string& place, OptionValue value, const std::string& help) {
    rows.push_back({name, place, std::move(value), help, topic, Unit::None, {}, Giver::All, 0, false, true, of_scans});
    return rows.back();
  }
  /// A field that only C++ can set; it is refused by its place.
  Option& library(const std::string& place, OptionValue value) {
    Option& row = add(place, place, std::move(value), "");
    row.giver = Giver::Library;
    return row;
  }
};

}  // namespace tank_datum::option_rows
