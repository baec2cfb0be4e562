#include "options/option.h"

#include <algorithm>
#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"

namespace tank_datum {
namespace {

std::string shown(double value) { return generalText(value); }

std::string shown(const Circle& circle) {
  return shown(circle.center.x()) + "," + shown(circle.center.y()) + "," + shown(circle.radius);
}

/// " m"
std::string suffixOf(Unit unit) {
  switch (unit) {
    case Unit::None:
      return "";
    case Unit::Metres:
      return " m";
    case Unit::Megapascals:
      return " MPa";
    case Unit::Degrees:
      return " deg";
    case Unit::ArcSeconds:
      return " arcsec";
  }
  return "";
}

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
  }
  return text;
}

/// The value refused, as a person would type it, if it is.
struct RefusedValue {
  const Option& option;
  using Text = std::optional<std::string>;

  Text number(double value) const { return option.bounds.hold(value) ? Text() : shown(value); }

  Text operator()(const bool*) const { return {}; }
  Text operator()(const int* value) const { return number(*value); }
  Text operator()(const std::size_t* value) const { return number(static_cast<double>(*value)); }
  Text operator()(const double* value) const { return number(option.typed(*value)); }
  Text operator()(const Fact& fact) const { return std::isnan(*fact.value) ? Text() : number(*fact.value); }
  Text operator()(const Path&) const { return {}; }
  Text operator()(const Places&) const { return {}; }
  Text operator()(const std::vector<std::string>*) const { return {}; }

  template <typename Number>
  Text operator()(const std::vector<Number>* values) const {
    for (std::size_t i = 0; i < values->size(); ++i) {
      const double value = (*values)[i];
      if (!option.bounds.hold(value) || (i > 0 && !(value > (*values)[i - 1]))) return shown(value);
    }
    return {};
  }
  Text operator()(const std::optional<Circle>* circle) const {
    if (!*circle || ((*circle)->center.allFinite() && option.bounds.hold((*circle)->radius))) return {};
    return shown(**circle);
  }
  Text operator()(const Choice& choice) const {
    const std::string word = choice.get();
    const bool known = std::find(choice.words.begin(), choice.words.end(), word) != choice.words.end();
    return known || (word.empty() && !choice.needed) ? Text() : word;
  }
};

}  // namespace

bool Bounds::hold(double value) const {
  if (!std::isfinite(value)) return false;
  if (or_zero && value == 0.0) return true;
  return (above ? value > low : value >= low) && (below ? value < high : value <= high);
}

std::string Bounds::text() const {
  const bool bottom = std::isfinite(low), top = std::isfinite(high);
  const std::string zero = or_zero ? "0 or " : "";
  if (bottom && top && !above && !below) return zero + shown(low) + " to " + shown(high);
  std::string words;
  if (bottom) words += (above ? "> " : ">= ") + shown(low);
  if (top) words += (bottom ? " and " : "") + std::string(below ? "< " : "<= ") + shown(high);
  return zero + (words.empty() ? "finite" : words);
}

std::string Option::text() const {
  const bool typed_with_unit = std::holds_alternative<Fact>(value) && unit == Unit::Metres;
  if ((unit != Unit::Metres && unit != Unit::Megapascals) || typed_with_unit) return help;
  std::string words = help;
  return words.insert(std::min(words.find_first_of(";:"), words.size()), " [" + suffixOf(unit).substr(1) + "]");
}

double Option::typed(double kept) const {
  constexpr double kRoundable = 1e250;  // beyond it what toDegrees rounds is infinite [rad]
  if (unit == Unit::Degrees) return std::abs(kept) < kRoundable ? toDegrees(kept) : kept / kDegree;
  return unit == Unit::ArcSeconds ? toArcSeconds(kept) : kept;
}

double Option::kept(double typed) const {
  return unit == Unit::Degrees ? typed * kDegree : unit == Unit::ArcSeconds ? typed / toArcSeconds(1.0) : typed;
}

double Option::given(double fact) const {
  if (std::isnan(fact)) throw Error(Error::Kind::Option, "options", {name, "nan", expected()});
  return fact;
}

std::string Option::expected() const {
  if (const auto* choice = std::get_if<Choice>(&value)) return alternatives(choice->words);
  if (std::holds_alternative<bool*>(value) || std::holds_alternative<Path>(value)) return {};
  if (std::holds_alternative<Places>(value) || std::holds_alternative<std::vector<std::string>*>(value)) return {};
  const bool bounded = std::isfinite(bounds.low) || std::isfinite(bounds.high);
  const std::string number = bounds.text() + (bounded ? suffixOf(unit) : "");
  const bool several =
      std::holds_alternative<std::vector<double>*>(value) || std::holds_alternative<std::vector<int>*>(value);
  if (several) return number + " and above the one before";
  if (std::holds_alternative<std::optional<Circle>*>(value)) return "X,Y,R, of which R " + number;
  return number;
}

std::optional<Refusal> Option::refused() const {
  const std::optional<std::string> bad = std::visit(RefusedValue{*this}, value);
  return bad ? std::make_optional<Refusal>({name, *bad, expected()}) : std::nullopt;
}

void Option::choose(const std::string& word) {
  const auto& choice = std::get<Choice>(value);
  const bool known = std::find(choice.words.begin(), choice.words.end(), word) != choice.words.end();
  if (!known && !(word.empty() && !choice.needed)) {
    throw Error(Error::Kind::Option, "options", {name, word, expected()});
  }
  choice.set(word);
}

}  // namespace tank_datum
