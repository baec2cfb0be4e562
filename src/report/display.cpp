#include "report/display.h"

#include "core/length_units.h"
#include "core/plain_text.h"

namespace tank_datum {

std::string signedText(double value, int digits) {
  const std::string text = fixedText(value, digits);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return value > 0.0 && !is_zero ? "+" + text : text;
}

Display::Display(const std::string& units) {
  if (units == "mm") return;
  const double feet = 1.0 / kMetresPerFoot;
  long_factor_ = feet, long_unit_ = "ft";
  if (units == "in") {
    short_factor_ = 12.0 * feet, short_unit_ = "in", further_ = 2;
    slope_factor_ = 1200.0, slope_unit_ = "in/100 ft";
  } else {
    short_factor_ = feet, short_unit_ = "ft", further_ = 3;
    slope_factor_ = 100.0, slope_unit_ = "ft/100 ft", further_slope_ = 1;
  }
}

std::string Display::shortText(double metres, int digits) const {
  return fixedText(short_factor_ * metres, digits + further_) + " " + short_unit_;
}

std::string Display::signedShort(double metres, int digits) const {
  return signedText(short_factor_ * metres, digits + further_);
}

std::string Display::longFigure(double metres, int digits) const { return fixedText(long_factor_ * metres, digits); }

std::string Display::longText(double metres, int digits) const { return longFigure(metres, digits) + " " + long_unit_; }

}  // namespace tank_datum
