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

/// The bins with standard errors as large as they are seen to be: points of a bin lie in rows and on one patch of a
/// rough surface, so that it errs more than its points' scatter says. By the second differences nearby, of which a
/// step moves few; elsewhere another surface may be rougher, or a gutter hold points of both its banks.
std::vector<SectionBin> withErrorsSeen(std::vector<SectionBin> bins);

}  // namespace tank_datum
