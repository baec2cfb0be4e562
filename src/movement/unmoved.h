#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/deviates.h"
#include "movement/movement_significance.h"

namespace tank_datum {

/// Leaves no station by itself (a Hampel filter): one that is further from the median of the stations within 2 degrees
/// than two and a half of its sigmas is put there. A shell carries no step over one degree, but scans have single
/// stations seven sigmas off. Stations with fewer than four such neighbours stay as they are.
class Steadied {
 public:
  explicit Steadied(const std::vector<MatchedStation>& stations);

  /// The stations with their dz so treated.
  const std::vector<MatchedStation>& of(const std::vector<MatchedStation>& stations);

 private:
  std::vector<std::vector<std::size_t>> beside_;
  std::vector<double> reach_;  ///< of a station's own, in sigmas [m]
  std::vector<MatchedStation> steadied_;
  std::vector<double> around_;
};

/// Comparisons of an unmoved tank. A station's own error is the mean of white noise along its window, so that stations
/// share errors as far as they share points; to it come the errors that the surveys say their stations share.
class Unmoved {
 public:
  Unmoved(const std::vector<MatchedStation>& stations, const CommonErrors& common, const MovementOptions& options);

  /// The stations with errors alone for dz.
  const std::vector<MatchedStation>& draw();

 private:
  struct Share {
    std::size_t first, width;
    double scale;
  };
  std::vector<MatchedStation> stations_;
  CommonErrors common_;
  CommonPart part_;
  std::size_t cells_ = 0;
  std::vector<Share> shares_;
  std::vector<double> own_;               ///< standard errors of the stations' own [m]
  std::vector<Eigen::Vector2d> towards_;  ///< the stations from the axis, of length 1
  Deviates normal_{20180419};
};

}  // namespace tank_datum
