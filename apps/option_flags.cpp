#include "option_flags.h"

#include "flag_names.h"
#include "io/whole_file.h"
#include "typed_text.h"

namespace tank_datum {

namespace {

/// CLI11 takes 010 for octal and 0x10 for hexadecimal: an integer is what it says, or refused.
std::string refusalOfInteger(const std::string& typed) {
  const std::size_t first = typed.find_first_not_of("+-");
  const bool starts_with_zero = first != std::string::npos && typed[first] == '0' && first + 1 < typed.size();
  return starts_with_zero ? typed + " is no decimal integer without leading zeros" : "";
}

}  // namespace

/// How each kind of option is declared. What CLI11 cannot put where it belongs is put there after the parsing.
struct OptionFlags::Declaration {
  OptionFlags& flags;
  CLI::App& app;
  const Option& option;
  std::string flag = flagOf(option.name);
  std::string names = (option.letter == 0 ? "" : std::string("-") + option.letter + ",") + flag;
  std::string help = withFlags(option.text());

  CLI::Option* operator()(bool* value) const {
    return app.add_flag(names + (option.negatable ? ",!--no" + flag.substr(1) : ""), *value, help);
  }
  CLI::Option* operator()(int* value) const { return app.add_option(names, *value, help)->check(refusalOfInteger, ""); }
  CLI::Option* operator()(std::size_t* value) const {
    return app.add_option(names, *value, help)->check(refusalOfInteger, "")->check(CLI::PositiveNumber);
  }
  CLI::Option* operator()(double* value) const {
    if (option.unit != Unit::Degrees && option.unit != Unit::ArcSeconds) return app.add_option(names, *value, help);
    double& typed = flags.numbers_.emplace_back(option.typed(*value));
    return after(app.add_option(names, typed, help),
                 [this_option = option, &typed, value] { *value = this_option.kept(typed); });
  }
  CLI::Option* operator()(std::vector<double>* values) const {
    return text([name = flag, values](const std::string& typed) { *values = numbersFrom(name, typed); });
  }
  CLI::Option* operator()(std::vector<int>* values) const {
    return text([name = flag, values](const std::string& typed) { *values = codesFrom(name, typed); });
  }
  CLI::Option* operator()(std::vector<std::string>* values) const {
    return text([name = flag, values](const std::string& typed) { *values = namesFrom(name, typed); });
  }
  CLI::Option* operator()(std::optional<Circle>* circle) const {
    return text([name = flag, circle](const std::string& typed) { *circle = circleFrom(name, typed); });
  }
  CLI::Option* operator()(const Fact& fact) const {
    if (option.unit == Unit::Metres) {
      return text([name = flag, fact](const std::string& typed) { *fact.value = lengthFrom(name, typed); });
    }
    std::optional<double>& typed = flags.facts_.emplace_back();
    return after(app.add_option(names, typed, help), [this_option = option, &typed, fact] {
      if (typed) *fact.value = this_option.given(*typed);
    });
  }
  CLI::Option* operator()(const Path& path) const {
    return option.name == "config" ? config() : app.add_option(names, *path.path, help);
  }
  /// CLI11 reads the file by itself, and waits for a pipe or reads a device without end: looked at before.
  CLI::Option* config() const {
    const auto look = [](const std::string& path) { return wholeFile(path, "command line"), std::string(); };
    return app.set_config(flag, "", help)->check(look, "");
  }
  CLI::Option* operator()(const Places& places) const { return app.add_option(names, *places.path, help); }
  CLI::Option* operator()(const Choice& choice) const {
    std::vector<std::string> words = choice.words;
    if (!choice.needed) words.insert(words.begin(), "");
    std::string& typed = flags.texts_.emplace_back(choice.get());
    return after(app.add_option(names, typed, help)->check(CLI::IsMember(words)),
                 [set = choice.set, &typed] { set(typed); });
  }

  /// An option read as text, and from it unless that is empty.
  CLI::Option* text(const std::function<void(const std::string&)>& read) const {
    std::string& typed = flags.texts_.emplace_back();
    return after(app.add_option(names, typed, help), [&typed, read] {
      if (!typed.empty()) read(typed);
    });
  }
  CLI::Option* after(CLI::Option* declared, std::function<void()> put) const {
    flags.to_be_put_.emplace_back(declared, std::move(put));
    return declared;
  }
};

OptionFlags::OptionFlags(CLI::App& app, const std::vector<Option>& options) {
  for (const Option& option : options) {
    if (option.giver == Giver::Library) continue;
    CLI::Option* declared = std::visit(Declaration{*this, app, option}, option.value);
    if (!option.configurable) declared->configurable(false);
  }
}

void OptionFlags::putTyped() const {
  for (const auto& [option, put] : to_be_put_) {
    if (option->count() > 0) put();
  }
}

}  // namespace tank_datum
