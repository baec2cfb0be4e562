#include "config_lines.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include "flag_names.h"
#include "io/whole_file.h"
#include "option_flags.h"
#include "options/option_table.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// What is expected of a line with this name: of an option that may stand in a file its values.
std::string expectedOf(const std::string& name) {
  RunOptions run;
  for (const Option& option : optionsOf(run)) {
    if (flagOf(option.name) != "--" + name || option.giver == Giver::Library) continue;
    if (!option.configurable) return "another option: " + flagOf(option.name) + " goes on the command line";
    if (std::holds_alternative<bool*>(option.value)) return "true or false";
    const std::string values = option.expected();
    return name + " = " + (values.empty() ? "a value as tank_datum --help says" : values);
  }
  return "NAME=VALUE of an option that tank_datum --help lists";
}

std::optional<std::string> refusalOf(const std::string& line);

/// What is expected of a line whose value is not taken: the same in quotes, where that is a list without them.
std::string expectedOf(const std::string& name, const std::string& value) {
  const std::string quoted = name + "=\"" + value + "\"";
  const bool list = value.find(',') != std::string::npos && value.find('"') == std::string::npos;
  return list && !refusalOf(quoted) ? quoted + ": a list stands in quotes" : expectedOf(name);
}

/// Why a line is refused; nothing when it is fine.
std::optional<std::string> refusalOf(const std::string& line) {
  const std::string name = trimmed(line.substr(0, line.find('=')));
  if (line.find('=') == std::string::npos) return expectedOf("");
  const std::string value = trimmed(line.substr(line.find('=') + 1));
  if (value.empty()) return expectedOf(name);                                // CLI11 takes it for no line at all
  if (value.front() == '[' && value.back() != ']') return expectedOf(name);  // would go on below
  RunOptions run;
  CLI::App app;
  const OptionFlags flags(app, optionsOf(run));
  app.allow_config_extras(CLI::config_extras_mode::error);
  std::istringstream alone(line + "\n");
  try {
    app.parse_from_stream(alone);
    flags.putTyped();
  } catch (const CLI::ParseError&) {
    return expectedOf(name, value);
  } catch (const Error& error) {
    return error.refused().expected;
  }
  if (const std::optional<Refusal> refused = firstError(run)) return name + " " + refused->expected;
  return std::nullopt;
}

}  // namespace

void requireConfigLines(const std::string& path) {
  if (path.empty()) return;
  constexpr std::ptrdiff_t kMostLines = 1000;  // many times the options there are; each takes a millisecond
  const std::string whole = wholeFile(path, "command line");
  if (whole.rfind("\xef\xbb\xbf", 0) == 0) {
    throw Error(Error::Kind::Option, "command line", path + " line 1", "a byte order mark", "UTF-8 without one");
  }
  const std::ptrdiff_t lines = std::count(whole.begin(), whole.end(), '\n');
  if (lines > kMostLines) {
    throw Error(Error::Kind::Option, "command line", path, std::to_string(lines) + " lines",
                "at most " + std::to_string(kMostLines));
  }
  std::istringstream text(whole);
  std::string line;
  std::set<std::string> named;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    line = trimmed(line);
    if (line.empty() || line.front() == '#' || line.front() == ';') continue;
    std::optional<std::string> expected = refusalOf(line);
    if (!expected && !named.insert(trimmed(line.substr(0, line.find('=')))).second) expected = "each option once";
    if (expected) {
      throw Error(Error::Kind::Option, "command line", path + " line " + std::to_string(number), line, *expected);
    }
  }
}

}  // namespace tank_datum
