#include "flag_names.h"

#include <algorithm>
#include <regex>

#include "core/printable.h"
#include "options/option_table.h"

namespace tank_datum {
namespace {

bool isFlag(const std::string& name) {
  RunOptions run;
  const std::vector<Option> options = optionsOf(run);
  return std::any_of(options.begin(), options.end(),
                     [&](const Option& o) { return o.name == name && o.giver != Giver::Library; });
}

/// A line about a file that is being written names it where it will be, not where it waits for that.
std::string withoutStaging(const std::string& line) {
  static const std::regex kWaiting(
      R"(/\.tank_datum-(commit|[0-9]+-[0-9]+)(/(new|old|lock|done\.json|journal\.json(\.part)?))?)");
  return std::regex_replace(line, kWaiting, "");
}

}  // namespace

std::string flagOf(const std::string& option) {
  std::string flag = "--" + option;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string withFlags(const std::string& text) {
  static const std::regex kOption("\\boption ([a-z_]+)\\b");
  std::string result;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), kOption), end; at != end; ++at) {
    const std::string name = (*at)[1];
    result.append(rest, (*at)[0].first);
    result += isFlag(name) ? flagOf(name) : at->str();
    rest = (*at)[0].second;
  }
  return result.append(rest, text.cend());
}

std::string lineOf(const Error& error) {
  const Refusal& refused = error.refused();
  const auto line = [&](const std::string& name, const std::string& expected) {
    return error.stage() + ": " + name + ", " + withShortWords(refused.value) + ", expected " + expected;
  };
  if (error.kind() == Error::Kind::File) return withoutStaging(line(refused.name, refused.expected));
  const std::string name = isFlag(refused.name) ? flagOf(refused.name) : withFlags(refused.name);
  // the value is the user's own, a file's name perhaps: it stays as it is
  return line(name, withFlags(refused.expected));
}

}  // namespace tank_datum
