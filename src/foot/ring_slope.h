#pragma once

#include <vector>

#include "fit/adaptive_smooth.h"

namespace tank_datum {

constexpr double kSteepestLip = 0.1;  ///< what seems steeper is drawn so by what lies beside it or on it [m/m]
constexpr double kLipSlope = 0.05;    ///< of the lips of annular plates: bent by the weld, by settlement [m/m]

/// What a lip's slope should be, and how far from it a ring's may seem to be by what scans do [m/m].
struct ExpectedSlope {
  double parallel;            ///< to what the plate lies on: most are
  double noise;               ///< what range noise may feign, up or down
  double lean;                ///< what beams that meet shell or edge too may feign, down only
  double more = 0;            ///< what else may, either way: it widens the error only
  double sigma_parallel = 0;  ///< standard error of parallel
};

/// A ring's slope, and its standard error [m/m].
struct MeanSlope {
  double seen = 0, slope = 0;  ///< as the windows show it, and as it is
  double sigma = 0;
  double sigma_seen = 0;  ///< of what the windows show
};

/// Slopes of a ring's lips.
struct RingSlopes {
  MeanSlope ring;                    ///< all together
  std::vector<SeriesValue> windows;  ///< each, with the error of how far it lies off the ring's; NaN where not seen
};

/// The slopes of a ring's lips as its windows show them together: how they change along the ring is a random process of
/// their own (followCircle()). Of few windows each is known by itself.
/// @param seen    slopes of the windows with the errors of what is seen
/// @param series  the same with what beams may feign in their errors too: that makes windows differ more, never less
/// @param common  what is in the errors of all of them as their scatter has it, and may be the lips' own [m/m]
RingSlopes drawTogether(const std::vector<SeriesValue>& seen, const std::vector<SeriesValue>& series, double common,
                        const ExpectedSlope& expected);

}  // namespace tank_datum
