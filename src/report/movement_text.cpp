#include "report/movement_text.h"

#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "report/words.h"

namespace tank_datum {
namespace {

std::string significance(bool shown, const std::string& language) {
  return say(language, shown ? "movement.significant" : "movement.not_significant");
}

std::string degreesText(double angle) { return fixedText(std::fmod(std::round(toDegrees(angle)), 360.0), 0) + " deg"; }

}  // namespace

std::vector<std::string> unsaidOf(const Movement& movement) {
  std::vector<std::string> keys;
  if (!movement.valid()) return keys;
  if (movement.removal == Removal::Nothing && movement.registration_error == 0.0) {
    keys.emplace_back("movement.one_height");
  }
  if (movement.removal != Removal::Tilt && movement.registration_tilt == 0.0) keys.emplace_back("movement.one_level");
  return keys;
}

std::string movementText(const Movement& movement, const Display& display, const std::string& language) {
  const auto lengths = [&](double value, double sigma, bool shown) {
    return Values{{"value", display.signedShort(value, 2) + " " + display.shortUnit()},
                  {"two_sigma", display.shortText(2.0 * sigma, 2)},
                  {"significance", significance(shown, language)}};
  };
  const auto arcseconds = [&](double slope) {
    return say(language, "unit.arcseconds", {{"value", fixedText(toArcSeconds(std::atan(slope)), 1)}});
  };
  Values rest = lengths(movement.max_rest, movement.sigma_rest, movement.rest_significant);
  rest.emplace_back("azimuth", degreesText(movement.rest_azimuth));
  std::string text =
      say(language, movement.moved() ? "movement.moved" : "movement.unmoved") + ": " +
      say(language, "movement.mean", lengths(movement.mean, movement.sigma_mean, movement.mean_significant)) + "; " +
      say(language, "movement.tilt",
          {{"value", arcseconds(movement.tilt_change)},
           {"two_sigma", arcseconds(2.0 * movement.sigma_tilt_change)},
           {"azimuth", degreesText(movement.rise_azimuth)},
           {"significance", significance(movement.tilt_significant, language)}}) +
      "; " + say(language, "movement.rest", rest) + "; " +
      say(language, "movement.stations",
          {{"count", std::to_string(movement.significant)}, {"of", std::to_string(movement.matched)}}) +
      ".";
  for (const std::string& key : unsaidOf(movement)) text += " " + say(language, key);
  return text;
}

}  // namespace tank_datum
