#pragma once

#include <cmath>
#include <vector>

namespace tank_datum {

/// The step that values, or a good part of them, were rounded to: the gap between levels that several share of which
/// most others are small multiples. 0: none is seen.
/// @param finest  steps are no smaller
double roundingStep(std::vector<double> values, double finest);

/// The same where most values are of one level, as elevations about a level floor, and the next ones of few: of the 21
/// levels that most values share, however far apart. Means of rounded values lie between.
double roundingStepBesideFloor(std::vector<double> values, double finest);

/// Standard deviation of what rounding does to the mean of many values: as much as to one where they are alike, next to
/// nothing where they scatter by half of a step (the first term of its Fourier series; Widrow and Kollar 2008).
/// @param scatter  of the values before they were rounded
double roundingError(double step, double scatter);

/// How values were rounded, and what they scatter by usually since they were spread over the steps.
struct Rounding {
  double step = 0;
  double scatter = HUGE_VAL;

  /// What it leaves in the mean of some values. A few that lie about the middle between two steps scatter by more than
  /// usual for that alone.
  /// @param own     what they scatter by, after they were spread
  /// @param spread  standard deviation of what is known to part them, which a fit takes away
  double errorOf(double own, double spread) const;
};

}  // namespace tank_datum
