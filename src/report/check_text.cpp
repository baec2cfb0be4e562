#include "report/check_text.h"

#include <cctype>
#include <cmath>

#include "core/plain_text.h"
#include "movement/limit_rates.h"
#include "report/words.h"

namespace tank_datum {
namespace {

/// The unit that value and limit of a check share.
Display::Scale scaleOf(const Check& check, const Display& display) {
  if (check.unit == "m/m") return display.slopes();
  if (check.unit == "1/m") return display.bends();
  if (check.unit != "m") return {1.0, check.unit, 4};
  const bool is_long = std::abs(check.value) >= 1.0 || std::abs(check.limit) >= 1.0;
  return is_long ? display.lengths() : display.shortLengths();
}

std::string figureIn(double value, const Display::Scale& scale, int further = 0) {
  return fixedText(scale.factor * value, scale.digits + further) + " " + scale.unit;
}

std::string signedIn(double value, const Display::Scale& scale) {
  return signedText(scale.factor * value, scale.digits + 1) + " " + scale.unit;
}

/// When, or whether, the limit is reached.
std::string approachText(const LimitRate& rate, const std::string& language) {
  const std::string key = std::string("limit_rate.") + nameOf(rate.approach);
  if (rate.approach == Approach::NotBefore) return say(language, key, {{"earliest", monthOf(rate.earliest)}});
  if (rate.approach != Approach::Reached) return say(language, key);
  const bool ends = std::isfinite(rate.latest);
  Values values = {{"expected", monthOf(rate.expected)}, {"earliest", monthOf(rate.earliest)}};
  if (ends) values.emplace_back("latest", monthOf(rate.latest));
  return say(language, ends ? key : "limit_rate.reached_open", values);
}

}  // namespace

std::string checkTitle(const Check& check, const std::string& language) {
  std::string key = "check_name.";
  for (const char c : check.name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (key.back() != '_') {
      key += '_';
    }
  }
  while (key.back() == '_') key.pop_back();
  return check.code + " " + sayOr(language, key, check.name);
}

std::string checkFigure(double value, const Check& check, const Display& display) {
  return figureIn(value, scaleOf(check, display));
}

std::string checkFigureWithInterval(const Check& check, const Display& display, const std::string& language) {
  const std::string figure = checkFigure(check.value, check, display);
  if (!check.interval.known()) return figure;
  const Display::Scale scale = scaleOf(check, display);
  return figure + " (" +
         say(language, "checks.interval",
             {{"low", fixedText(scale.factor * check.interval.low, scale.digits)},
              {"high", figureIn(check.interval.high, scale)}}) +
         ")";
}

std::string limitRatesText(const LimitRates& rates, const Display& display, const std::string& language) {
  if (rates.rates.empty()) return say(language, rates.none);
  const LimitRate& first = rates.rates.front();
  const Display::Scale scale = scaleOf(first.check, display);
  return say(language, "limit_rate.sentence",
             {{"check", checkTitle(first.check, language)},
              {"rate", signedIn(first.rate, scale)},
              {"two_sigma", figureIn(2.0 * first.sigma, scale, 1)},
              {"limit", figureIn(first.check.limit, scale)},
              {"outcome", approachText(first, language)}});
}

}  // namespace tank_datum
