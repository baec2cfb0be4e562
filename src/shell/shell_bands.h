#pragma once

#include <Eigen/Core>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "tank_datum/locate/tank.h"
#include "tank_datum/shell/shell_survey.h"

namespace tank_datum {

constexpr double kSteepestShell = 0.01;  ///< no shell that stands leans by more [m/m]

/// The points of a scan at the heights of a shell survey, gathered block by block in bounded memory: of every half
/// degree and height those of the lowest hashes, all of them where they are few. The same points are kept in whatever
/// order they come.
class ShellBands {
 public:
  /// @param points  of the scan: of more than kPointsLookedAt every n-th one is looked at
  ShellBands(const Tank& tank, const ShellOptions& options, std::uint64_t points = 0);

  /// Takes what it wants of the points of the scan's n-th block, those that lie near the shell at about one of the
  /// heights; from any number of threads.
  void gather(std::uint64_t n, const Points& block);

  /// Above the datum, also those that nothing was seen at [m].
  const std::vector<double>& heights() const { return heights_; }
  Side side() const { return side_; }
  /// What was kept of one of them, relative to the scan's origin.
  Points points(std::size_t height) const;

 private:
  struct Kept {
    std::uint32_t hash;
    Eigen::Vector3f point;  ///< about the centre of the foot: micrometres in 4 bytes

    /// The lower hash first; of two alike that of the lower coordinates, so that no order of the scan tells.
    static bool isLower(const Kept& a, const Kept& b);
  };
  struct Cell {
    std::atomic<std::uint64_t> limit{std::uint64_t{1} << 32};  ///< hashes from here on are not kept
    std::vector<Kept> kept;                                    ///< at most twice the capacity
  };
  /// The cells of a height by sector; none until a point is seen there, then published when they are whole.
  struct Band {
    Cell* seen() const { return published.load(std::memory_order_acquire); }
    Cell* made();  ///< while `adding` is held

    std::unique_ptr<Cell[]> cells;
    std::atomic<Cell*> published{nullptr};
    std::mutex adding;
  };
  /// A point to be put into a band, and the one before it that goes there too; kNone: there is none.
  struct Pending {
    static constexpr std::size_t kNone = ~std::size_t{0};
    Kept kept;
    std::size_t sector, before;
  };
  /// Where a point belongs: the bands first ... end - 1 of a sector.
  struct Place {
    std::size_t first, end, sector;
    std::uint32_t hash;
  };
  bool placeOf(const Eigen::Vector3d& p, Place& place) const;
  bool wants(std::size_t band, const Place& place) const;
  void put(Cell& cell, const Kept& kept) const;

  Side side_;
  Eigen::Vector3d foot_;              ///< centre [m]
  Eigen::Vector2d slope_;             ///< of the foot [m/m]
  double inner_ = 0.0, outer_ = 0.0;  ///< squared distances from the centre beyond which there is no shell [m2]
  double radius_, reach_;             ///< of the circle, and about it [m]
  double half_;                       ///< of a band, enlarged by what the coarse foot may be off [m]
  std::size_t capacity_;              ///< of a cell
  std::uint64_t stride_;              ///< odd, since rows of a scan often have even lengths
  std::vector<double> heights_;
  double per_metre_;                     ///< places of first_band_ a metre
  std::vector<std::size_t> first_band_;  ///< by places above the lowest band
  std::vector<Band> bands_;              ///< by height
};

}  // namespace tank_datum
