#include "limits/limit_formula.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

const std::string kLetters = "DHYELS";

/// Reads the text of a formula from left to right.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  bool done() {
    at_ = std::min(text_.find_first_not_of(' ', at_), text_.size());
    return at_ == text_.size();
  }
  bool take(char c) {
    const bool there = !done() && text_[at_] == c;
    if (there) ++at_;
    return there;
  }
  std::optional<char> letter() {
    if (done() || kLetters.find(text_[at_]) == std::string::npos) return {};
    return text_[at_++];
  }
  template <typename Value>
  std::optional<Value> number() {
    Value value{};
    if (done()) return {};
    const char *first = text_.data() + at_, *last = text_.data() + text_.size();
    const auto read = std::from_chars(first, last, value);
    if (read.ec != std::errc()) return {};
    at_ += static_cast<std::size_t>(read.ptr - first);
    return value;
  }

 private:
  std::string text_;
  std::size_t at_ = 0;
};

/// Multiplies the next factor, or with sign -1 its inverse, into the formula.
bool takeFactor(Reader& reader, int sign, LimitFormula& formula) {
  if (const auto letter = reader.letter()) {
    int power = 1;
    if (reader.take('^')) {
      const auto read = reader.number<int>();
      if (!read) return false;
      power = *read;
    }
    formula.powers[*letter] += sign * power;
    return true;
  }
  const auto number = reader.number<double>();
  if (!number || !(*number > 0.0) || !std::isfinite(*number)) return false;
  formula.factor *= sign > 0 ? *number : 1.0 / *number;
  return true;
}

}  // namespace

std::optional<double> LimitFormula::at(const std::map<char, double>& given) const {
  double value = factor;
  for (const auto& [letter, power] : powers) {
    const auto found = given.find(letter);
    if (found == given.end()) return {};
    value *= portable::pow(found->second, power);
  }
  return value;
}

std::optional<LimitFormula> parseFormula(const std::string& text) {
  LimitFormula formula;
  formula.factor = 1.0;
  Reader reader(text);
  int sign = 1;
  do {
    if (!takeFactor(reader, sign, formula)) return {};
    if (reader.done()) return formula;
    sign = reader.take('/') ? -1 : 1;
  } while (sign < 0 || reader.take('*'));
  return {};
}

}  // namespace tank_datum
