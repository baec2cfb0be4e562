#pragma once

#include <utility>
#include <vector>

#include "core/units.h"
#include "tank_datum/core/default_init_allocator.h"
#include "tank_datum/io/scan.h"

namespace tank_datum {

/// A ring point seen from the tank's axis.
struct PolarPoint {
  double azimuth;  ///< counter-clockwise from +x, in [0, 2 pi) [rad]
  double radius;   ///< [m]
  double z;        ///< [m]
};

using PolarPoints = std::vector<PolarPoint, DefaultInitAllocator<PolarPoint>>;

/// The ring's points in order of azimuth, for windows round the tank.
class PolarRing {
 public:
  PolarRing(const Points& points, const Eigen::Vector2d& center);
  /// Of points in order of azimuth.
  explicit PolarRing(PolarPoints points) : points_(std::move(points)) {}

  /// Calls visit(point, turn) for every point whose azimuth is within half_width of `azimuth`, in order of turn, the
  /// signed difference [rad].
  template <typename Visit>
  void around(double azimuth, double half_width, Visit&& visit) const {
    for (const double shift : {kTwoPi, 0.0, -kTwoPi}) {
      for (std::size_t i = firstFrom(azimuth + shift - half_width); i < points_.size(); ++i) {
        const double turn = points_[i].azimuth - shift - azimuth;
        if (turn > half_width) break;
        visit(points_[i], turn);
      }
    }
  }

  const PolarPoints& points() const { return points_; }
  /// Indices of the first point in a cell of so many equal ones, of which the first begins at azimuth 0, and beyond it.
  std::pair<std::size_t, std::size_t> inCell(std::size_t cell, std::size_t cells) const;
  /// Index of the first point at an azimuth or beyond; the number of points if there is none.
  std::size_t firstFrom(double azimuth) const;

 private:
  PolarPoints points_;
};

}  // namespace tank_datum
