#pragma once

#include <vector>

#include "shape/second_differences.h"
#include "shape/simulated_surveys.h"
#include "stations/ring_rows.h"
#include "stations/ring_series.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The figures of a datum's shape that limits may judge, each with the interval of the largest round the tank.
class Figures {
 public:
  Figures(const std::vector<Station>& stations, double radius, const SimulatedSurveys& surveys);

  /// Figures between survey points: second differences, DeBeer's distortion, heights of neighbours.
  void addNeighbours(const SecondDifferences& differences, const SurveyPlan& plan);
  /// Along the shell: the height in 10 m, the levels within 9 m and 3 m and over the circumference.
  void addLevels(Analysis& analysis);
  void addCurvature(OutOfPlane& fit);
  void addOutOfPlane(OutOfPlane& fit);
  void addArcs(const std::vector<SettlementArc>& arcs);

  const std::vector<Measure>& all() const { return all_; }

 private:
  struct Ring {
    RingSeries u, z;
  };
  Measure& add(const std::string& quantity, const PlacedValue& worst, const char* without);
  Interval95 intervalOf(const RingRows& seen, const RingRows& whole, bool of_u) const;

  const std::vector<Station>& stations_;
  double radius_;
  const SimulatedSurveys& surveys_;
  Ring seen_, whole_;
  std::vector<Measure> all_;
};

}  // namespace tank_datum
