#include "report/movement_text.h"

#include <cmath>

#include "core/azimuth.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "report/words.h"

namespace tank_datum {
namespace {

/// @param taken  out of the differences: then nothing is known of it
std::string significance(bool shown, bool taken, const std::string& language) {
  return say(language, taken ? "movement.taken" : shown ? "movement.significant" : "movement.not_significant");
}

/// The verdict's key: of what was taken out of the differences nothing is said.
const char* wordOf(const Movement& movement) {
  if (movement.moved()) return "movement.moved";
  if (movement.removal == Removal::Nothing) return "movement.unmoved";
  return movement.removal == Removal::Mean ? "movement.unmoved_mean" : "movement.unmoved_tilt";
}

/// The directions of the stations that are in both surveys [rad].
std::vector<double> sharedDirections(const Movement& movement) {
  std::vector<double> directions;
  for (const StationMovement& s : movement.stations) {
    if (std::isfinite(s.dz)) directions.push_back(withinTurn(s.direction));
  }
  return directions;
}

std::string degreesText(double angle) { return fixedText(wholeDegrees(angle), 0) + " deg"; }

}  // namespace

std::vector<std::string> unsaidOf(const Movement& movement) {
  constexpr double kApart = 0.02;  // [m]; what no scans of one tank in one frame are apart by
  constexpr double kDeep = 0.5;    // [m]; by which few tanks settle
  std::vector<std::string> keys;
  if (!movement.valid()) return keys;
  if (movement.removal == Removal::Nothing && movement.registration_error == 0.0) {
    keys.emplace_back("movement.one_height");
  }
  if (movement.removal != Removal::Tilt && movement.registration_tilt == 0.0) keys.emplace_back("movement.one_level");
  if (movement.removal != Removal::Tilt && widestArc(sharedDirections(movement)) > kPi)
    keys.emplace_back("movement.part_of_ring");
  if (movement.rod_taken_out) keys.emplace_back("movement.rod_height");
  if (movement.fits_turned) keys.emplace_back("movement.fits_turned");
  if (movement.rms == 0.0 && movement.mean == 0.0) keys.emplace_back("movement.one_survey");
  if (movement.removal == Removal::Nothing && std::abs(movement.mean) > kDeep)
    keys.emplace_back("movement.heights_apart");
  if (movement.centre_apart > kApart) keys.emplace_back("movement.centres_apart");
  return keys;
}

std::string movementText(const Movement& movement, const Display& display, const std::string& language) {
  const bool mean_taken = movement.removal != Removal::Nothing, tilt_taken = movement.removal == Removal::Tilt;
  const auto lengths = [&](double value, double sigma, bool shown, bool taken) {
    return Values{{"value", display.signedShort(value, 2) + " " + display.shortUnit()},
                  {"two_sigma", display.shortText(2.0 * sigma, 2)},
                  {"significance", significance(shown, taken, language)}};
  };
  const auto arcseconds = [&](double slope) {
    return say(language, "unit.arcseconds", {{"value", fixedText(toArcSeconds(portable::atan(slope)), 1)}});
  };
  Values rest = lengths(movement.max_rest, movement.sigma_rest, movement.rest_significant, false);
  rest.emplace_back("azimuth", degreesText(movement.rest_azimuth));
  const bool tilt_shown = movement.tilt_significant && !tilt_taken;  // else its direction is not known
  const std::string risen =
      tilt_shown ? say(language, "movement.risen", {{"azimuth", degreesText(movement.rise_azimuth)}}) : "";
  std::string text = say(language, wordOf(movement)) + ": " +
                     say(language, "movement.mean",
                         lengths(movement.mean, movement.sigma_mean, movement.mean_significant, mean_taken)) +
                     "; " +
                     say(language, "movement.tilt",
                         {{"value", arcseconds(movement.tilt_change)},
                          {"two_sigma", arcseconds(2.0 * movement.sigma_tilt_change)},
                          {"risen", risen},
                          {"significance", significance(movement.tilt_significant, tilt_taken, language)}}) +
                     "; " + say(language, "movement.rest", rest) + "; " +
                     say(language, "movement.stations",
                         {{"count", std::to_string(movement.significant)}, {"of", std::to_string(movement.matched)}}) +
                     ".";
  constexpr double kWorthSaying = 1.25;
  if (movement.errors_used > kWorthSaying)
    text += " " + say(language, "movement.errors_used", {{"factor", fixedText(movement.errors_used, 1)}});
  for (const std::string& key : unsaidOf(movement)) text += " " + say(language, key);
  return text;
}

}  // namespace tank_datum
