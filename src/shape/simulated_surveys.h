#pragma once

#include <functional>
#include <vector>

#include "shape/ring_doubts.h"
#include "shape/ring_model.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// What is read of a ring of values: one number per place, in order.
using RingFigure = std::function<double(const double* values)>;

/// Intervals for figures that are the largest of many, from surveys as the model says they could have been.
///
/// The lower end takes from the figure what errors add to it: the same errors on a datum of those waves only that stand
/// out of them. The upper end is that of a datum as likely as the survey leaves it, beyond what the same survey of it
/// would give, in gaps too, and as far off as what was refused there or a bridge's own error allow.
class SimulatedSurveys {
 public:
  /// @param radius  of the tank [m]
  SimulatedSurveys(const std::vector<Station>& stations, double radius, const StationCovariance& covariance);

  const RingModel& model() const { return model_; }
  /// Whether errors are known: given, or shown by more than 64 stations.
  bool valid() const { return valid_; }

  /// The stations with every gap filled: a ring for figures of the whole circumference.
  const std::vector<Station>& wholeRing() const { return whole_; }

  /// Interval of a figure of z, or of U.
  /// @param seen   of the values at the stations that have an elevation
  /// @param whole  of those at wholeRing(); empty: nothing is asked of what was not seen
  /// @param of_u   whether the plane is taken out first
  Interval95 intervalOf(const RingFigure& seen, const RingFigure& whole, bool of_u) const;

  /// Interval of a figure of z about its mean all round, which what was not seen may move up or down.
  Interval95 aboutWhole(const RingFigure& seen, const RingFigure& whole) const;

  /// Interval of a figure of U's waves 2 to `order` at the stations that have an elevation.
  Interval95 ofWaves(int order, const RingFigure& seen) const;

  /// Interval of the largest |curvature| of the waves 2 to `order` [1/m].
  Interval95 curvature(int order) const;

 private:
  struct Values {
    Eigen::MatrixXd estimates, truths;   ///< at the stations with an elevation, one column per draw
    Eigen::MatrixXd possible;            ///< truths there, with doubts
    Eigen::MatrixXd whole;               ///< the same at the whole ring
    Eigen::VectorXd surveyed, standing;  ///< as surveyed; of the waves that stand out of the errors
  };
  Values valuesOf(bool of_u) const;
  void addDoubts(const std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>& doubts_at, Values& values) const;
  Values raw(Values values, bool of_u) const;
  Values wavesTo(int order, bool curvature) const;
  static std::vector<double> missedBy(const Values& values, const RingFigure& seen, const RingFigure& whole);
  static Interval95 interval(const Values& values, const RingFigure& seen, const RingFigure& whole);
  Interval95 widened(const Values& values, const RingFigure& seen, const RingFigure& whole) const;

  double radius_;
  RingModel model_;
  bool valid_ = false;
  std::vector<Station> known_, whole_;  ///< those with an elevation, measured or interpolated; with gaps filled
  Eigen::VectorXd known_azimuths_, whole_azimuths_;
  RingModel::Simulated draws_;
  RingDoubts doubts_;
  Eigen::MatrixXd doubted_;  ///< [gaps in doubt x draws]
  Values z_, u_;
};

}  // namespace tank_datum
