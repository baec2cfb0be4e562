#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "tank_datum/locate.h"
#include "tank_datum/shell_survey.h"

namespace tank_datum {

/// The points of a scan at the heights of a shell survey, gathered block by block in bounded memory: of every half
/// degree and height a random sample, all of them where they are few (reservoir sampling, Vitter 1985; the draws are a
/// hash of the cell and the count, so the same scan gives the same sample).
class ShellBands {
 public:
  ShellBands(const Tank& tank, const ShellOptions& options);

  /// Whether a point lies near the shell, at about one of the heights or between them.
  bool holds(const Eigen::Vector3d& p) const;

  /// Takes those of a block that it holds.
  void add(const Points& block);

  /// Above the datum, also those that nothing was seen at [m].
  const std::vector<double>& heights() const { return heights_; }
  /// What was kept of one of them, relative to the scan's origin.
  Points points(std::size_t height) const;

 private:
  struct Cell {
    std::uint64_t seen = 0;
    std::vector<Eigen::Vector3f> kept;  ///< about the centre of the foot: micrometres in 4 bytes
  };
  void put(Cell& cell, std::uint64_t key, const Eigen::Vector3f& p) const;

  Eigen::Vector3d foot_;              ///< centre [m]
  Eigen::Vector2d slope_;             ///< of the foot [m/m]
  double inner_ = 0.0, outer_ = 0.0;  ///< squared distances from the centre beyond which there is no shell [m2]
  double radius_, reach_;             ///< of the circle, and about it [m]
  double half_;                       ///< of a band, enlarged by what the coarse foot may be off [m]
  std::size_t capacity_;              ///< of a cell
  std::vector<double> heights_;
  std::vector<std::vector<Cell>> bands_;  ///< by height and sector; empty until a point is seen at the height
};

}  // namespace tank_datum
