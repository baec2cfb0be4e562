#pragma once

#include <vector>

#include "movement/epoch_matching.h"

namespace tank_datum {

/// Pairs of stations as far apart as neighbours that share no errors: they tell errors from a sector that moved. Such a
/// sector spreads the stations' values, but few pairs have one end in it and the other outside.
class RingPairs {
 public:
  /// @param stations  by direction; not owned
  explicit RingPairs(const std::vector<MatchedStation>& stations);

  /// What the stations are apart, whatever the gaps [rad].
  double step() const { return step_; }
  /// Places between stations that share no errors; 0: the stations are too few to tell.
  std::size_t widest() const { return widest_; }
  /// Robust standard deviation of the stations' values: that of the pairs, without a plane that a sector tilted, where
  /// it is the less. (Errors that change sign over such an arc spread the pairs.) That of the values alone where fewer
  /// than a third of the stations have such a pair.
  double scatterOf(const std::vector<double>& values) const;
  /// Robust autocorrelation of values `lag` places apart, by their differences (a robust variogram as of Genton,
  /// Mathematical Geology 30, 1998, with the biweight midvariance as scale); NaN without pairs.
  /// @param scatter  scatterOf() them
  double correlationAt(const std::vector<double>& values, std::size_t lag, double scatter) const;

 private:
  /// First stations of the pairs so many places apart, not over a gap. Values that stand out from the rest have moved,
  /// and do not count.
  std::vector<std::size_t> pairsAt(const std::vector<double>& values, std::size_t lag) const;
  double arc(std::size_t at, std::size_t lag) const;

  const std::vector<MatchedStation>& stations_;
  double step_ = 0.0;
  std::size_t widest_ = 0;
};

}  // namespace tank_datum
