#pragma once

#include <string>

namespace tank_datum {

/// "+6.0", "-6.0": a figure with its sign; one that is shown as zero has none.
std::string signedText(double value, int digits);

/// Lengths as people read them: short ones in mm, in or ft, long ones in m or ft. Kept as page/js/00_units.js has it.
class Display {
 public:
  /// @param units  "mm", "in" or "ft"
  explicit Display(const std::string& units = "mm");

  /// "6.0 mm": a length in metres, with the digits that millimetres would have.
  std::string shortText(double metres, int digits = 1) const;
  /// "+6.0": the same with its sign, without the unit; a zero has none.
  std::string signedShort(double metres, int digits = 1) const;
  /// "5.000 m"
  std::string longText(double metres, int digits = 3) const;
  /// "5.000", for lists with one unit behind them.
  std::string longFigure(double metres, int digits = 3) const;

  /// What a figure in metres is multiplied by, its unit then, and its digits.
  struct Scale {
    double factor;
    std::string unit;
    int digits;
  };
  Scale shortLengths() const { return {short_factor_, short_unit_, 1 + further_}; }
  Scale lengths() const { return {long_factor_, long_unit_, 3}; }
  Scale slopes() const { return {slope_factor_, slope_unit_, 2 + further_slope_}; }
  /// Of curvatures, in millionths.
  Scale bends() const { return {1e6 / long_factor_, std::string("x 10^-6 1/") + long_unit_, 1}; }

  int digits(int of_millimetres) const { return of_millimetres + further_; }
  double shortFactor() const { return short_factor_; }
  const char* shortUnit() const { return short_unit_; }
  const char* longUnit() const { return long_unit_; }

 private:
  double short_factor_ = 1e3, long_factor_ = 1.0, slope_factor_ = 1e3;
  const char *short_unit_ = "mm", *long_unit_ = "m", *slope_unit_ = "mm/m";
  int further_ = 0, further_slope_ = 0;  ///< digits of short lengths and slopes
};

}  // namespace tank_datum
