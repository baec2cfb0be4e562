#pragma once

#include <vector>

namespace tank_datum {

/// Standard deviation of what is the one value or the other, or between: of their difference, 1 / sqrt(12) rounded up.
constexpr double kEither = 0.3;

/// Values round a ring as one random process saw them.
struct RingProcess {
  std::vector<double> value;  ///< what the values follow, at every place, those without a value too
  std::vector<double> sigma;  ///< its standard error
  std::vector<double>
      doubt;  ///< how many standard deviations a value lies off what the others say; 0 where there is none
  std::vector<double> strayed;  ///< how far such a value lies off, at its place and up to the next values [m]
  std::vector<double>
      shape;  ///< standard error of the harmonics that is in `sigma`, if any: in long gaps they may do much
  std::vector<double> bent;  ///< how far bends of the ring move `value`, as other places do not show them [m]
  double amplitude = 0;      ///< standard deviation of the process
  double length = 0;         ///< along which it is alike [rad]
  double nugget = 0;         ///< what the values scatter beside their standard errors
  double scale = 1;          ///< what their standard errors count for, beside the nugget

  bool valid() const { return amplitude > 0.0; }
  /// Whether a value lies on it at a place, within three standard errors of both.
  bool holds(double at_place, double its_sigma, std::size_t place) const;
  /// Its standard error as the values that it follows make it: without what those that it does not follow add, and what
  /// harmonics may do in gaps.
  double sigmaOfFollowed(std::size_t place) const;
  /// Its standard error if the harmonics go on through a gap as the values beside it say.
  double sigmaIfShaped(std::size_t place) const;
};

/// What values at equal steps round a ring follow: low harmonics and a Matern process of order 3/2 (Rasmussen and
/// Williams 2006, 4.2), whose amplitude and length, and the values' scatter beside their standard errors, are those
/// under which the values are likeliest; the scatter no less than ringScatter(), as a process that has to follow a dip
/// may follow the scatter of the rest as well. So neighbours help as far as the values show that they are alike, and no
/// further. A value more than four standard deviations off what the others say counts for what it is off. Kalman filter
/// and smoother (Rauch, Tung and Striebel 1965), linear in the number of values.
/// @param values  NaN where unknown
/// @param sigmas  their standard errors, independent of each other
/// @param least_amplitude  of the process, however quiet the ring: what a dip may be that only few of the values see
/// @return not valid for fewer than eight values
RingProcess followRing(const std::vector<double>& values, const std::vector<double>& sigmas, double least_amplitude);

}  // namespace tank_datum
