#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "setups/setup_adjustment.h"
#include "setups/setup_system.h"

namespace tank_datum {

/// The arcs with the errors they have on top of their points'.
class Overlaps {
 public:
  /// @param arcs  must outlive this
  Overlaps(const std::vector<ArcView>& arcs, std::size_t setups)
      : arcs_(arcs), setups_(setups), weights_(arcs.size(), 1.0) {}

  SetupSystem system() const;

  /// The same without the arcs within six degrees of an azimuth.
  SetupSystem systemWithout(double azimuth) const;

  /// Azimuths of arcs in which a setup is seen, a few degrees apart.
  std::vector<double> placesOf(std::size_t setup) const;

  /// Errors of the arcs, and weights, from what the solution leaves over.
  void learnFrom(const SetupSolution& solution);

  /// Offsets that the errors do not explain.
  Eigen::VectorXd left(const ArcView& arc, const Eigen::VectorXd& errors) const;

  const std::vector<ArcView>& arcs() const { return arcs_; }
  std::size_t setups() const { return setups_; }

 private:
  void add(std::size_t arc, SetupSystem& sum) const;
  /// Square of what is left in an arc over what is expected, per degree of freedom: its median is 1 in the mean.
  double misfit(const ArcView& arc, const Eigen::VectorXd& errors, double extra) const;
  /// The error common to an arc's points for which the median misfit is 1 (after Mandel and Paule 1970).
  double extraOf(const SetupSolution& solution, bool shell) const;

  const std::vector<ArcView>& arcs_;
  std::size_t setups_;
  std::vector<double> weights_;
  double extra_[2] = {0.0, 0.0};
};

/// Of the foundation: each setup against the mean of the others in its arcs, and all of them together.
void measureDiscrepancy(const Overlaps& overlaps, SetupAdjustment& result);

}  // namespace tank_datum
