#pragma once

#include <string>

namespace tank_datum {

/// Lengths as people read them: short ones in mm, in or ft, long ones in m or ft. Kept as page/js/00_units.js has it.
class Display {
 public:
  /// @param units  "mm", "in" or "ft"
  explicit Display(const std::string& units = "mm");

  /// "6.0 mm": a length in metres, with the digits that millimetres would have.
  std::string shortText(double metres, int digits = 1) const;
  /// "+6.0": the same with its sign, without the unit.
  std::string signedShort(double metres, int digits = 1) const;
  /// "5.000 m"
  std::string longText(double metres, int digits = 3) const;
  /// "5.000", for lists with one unit behind them.
  std::string longFigure(double metres, int digits = 3) const;

  int digits(int of_millimetres) const { return of_millimetres + further_; }
  double shortFactor() const { return short_factor_; }
  const char* shortUnit() const { return short_unit_; }
  const char* longUnit() const { return long_unit_; }
  /// A slope as "8.83 mm/m".
  std::string slopeText(double slope) const;

 private:
  double short_factor_ = 1e3, long_factor_ = 1.0, slope_factor_ = 1e3;
  const char *short_unit_ = "mm", *long_unit_ = "m", *slope_unit_ = "mm/m";
  int further_ = 0, further_slope_ = 0;  ///< digits of short lengths and slopes
};

}  // namespace tank_datum
