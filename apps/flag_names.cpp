#include "flag_names.h"

#include <algorithm>
#include <regex>

#include "options/option_table.h"

namespace tank_datum {
namespace {

bool isFlag(const std::string& name) {
  RunOptions run;
  const std::vector<Option> options = optionsOf(run);
  return std::any_of(options.begin(), options.end(),
                     [&](const Option& o) { return o.name == name && o.giver != Giver::Library; });
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
  if (error.kind() == Error::Kind::File) return error.what();
  const Refusal& refused = error.refused();
  const std::string name = isFlag(refused.name) ? flagOf(refused.name) : withFlags(refused.name);
  // the value is the user's own, a file's name perhaps: it stays as it is
  return error.stage() + ": " + name + ", " + refused.value + ", expected " + withFlags(refused.expected);
}

}  // namespace tank_datum
