#pragma once

#include <cstddef>
#include <vector>

namespace tank_datum {

/// A bin of a section across the shell: where it lies, its elevation and the standard error of that [m].
struct SectionBin {
  double d, z, error;
};

/// A line through bins whose slope is known beforehand to what foundations have, and its variance at a place.
struct SectionLine {
  double middle = 0, height = 0, slope = 0;
  double variance = 0, variance_slope = 0;  ///< of the height in the middle, of the slope

  double at(double d) const { return height + slope * (d - middle); }
  double varianceAt(double d) const { return variance + variance_slope * (d - middle) * (d - middle); }
};

/// Bins [first, last) of a section.
struct BinRange {
  std::size_t first, last;
};

/// Weighted least squares through bins, with the slope as one more observation of 0. Where bins lie further off the
/// line than their errors allow, its variances are as much larger.
/// @param steepest  standard error of that [m/m]
SectionLine lineThrough(const std::vector<SectionBin>& bins, BinRange range, double steepest);

/// Where a section parts: bins before `end`, and those from `begin` on, lie on two lines. What is between holds points
/// of both.
struct Jump {
  std::size_t end = 0, begin = 0;
  double over = 0;  ///< by how much the lines' distance there exceeds what errors and `least` allow [m]

  bool found() const { return over > 0.0; }
};

/// What is looked for.
struct JumpScales {
  double least;   ///< a smaller jump is none [m]
  double mixed;   ///< an edge that does not follow the shell, or seen along slanting rays, is as wide as this [m]
  double length;  ///< of the lines on either side [m]
};

/// The clearest jump of a section that one line through both sides does not explain, in which neighbouring bins may
/// differ by less than bins tell.
Jump clearestJump(const std::vector<SectionBin>& bins, const JumpScales& scales);

}  // namespace tank_datum
