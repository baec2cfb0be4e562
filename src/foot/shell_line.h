#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/units.h"
#include "foot/polar_ring.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// Noise over the reach of the section up to which surfaces at different heights, or a shell's bends, can be told; a
/// lip and its ringwall are 0.02 apart.
constexpr double kResolved = 0.01;

/// Noises off the shell's outline within which points are taken for the shell's.
constexpr double kOnShell = 6.0;

/// The shell's surface near its foot at one azimuth: radius = radius + turn_slope * t + lean * h, with the arc t from
/// the azimuth [m] and the height h above the foot [m].
struct ShellLine {
  double radius = kUnknown;        ///< at the foot [m]
  double sigma_radius = kUnknown;  ///< its standard error [m]
  double sigma_along = 0;          ///< what of that turn and bend leave [m]
  double turn_slope = 0;           ///< [m/m]
  double bend = 0;                 ///< second-order term in t [1/m]
  double lean = 0;                 ///< [m/m]
  double noise = kUnknown;         ///< standard deviation of the points about the line [m]
  double straight_to = kUnknown;   ///< height up to which it is the shell; farther up that may bend away [m]
  std::size_t points = 0;          ///< behind it; 0 when the shell is not seen here
  double before = kUnknown;        ///< arc to the nearest of them on the one side [m]
  double after = kUnknown;         ///< and on the other

  bool seen() const { return points > 0; }
  /// Whether the shell is seen within this step of azimuth [m] itself, or between two columns of points so close that
  /// the scan may just be that coarse; otherwise only the neighbours' shell is seen.
  bool isSupportedWithin(double step) const;
  double at(double t, double h) const { return radius + turn_slope * t + bend * t * t + lean * h; }
};

/// The shell as a first picture: the radius where the ring's points above the foot lie densest, cell by cell.
struct ShellOutline {
  std::vector<double> radius;  ///< per equal cell of azimuth [m], NaN where nothing stands
  double noise = 0;            ///< typical spread of a cell's points about its radius [m]

  /// Whether what is seen up to a height [m] is more than noise.
  bool isResolved(double height) const { return noise <= kResolved * height; }
  double at(double azimuth) const;  ///< [m], between the two cells beside it, NaN where none is within three cells
};

/// What a shell's radius may change by along an arc [m]: a lobe of +-50 mm over 3 m turns it by 0.1; an oval by a few
/// thousandths over any arc.
inline double bendAlong(double arc) { return 0.15 * std::min(arc, 0.5) + 0.005 * arc; }

/// From the points that are surely above the foot, without objects before the shell.
ShellOutline outlineShell(const PolarRing& ring, const Tank& tank, double reach);

/// From all points: a band of a shell that nothing else meets.
ShellOutline outlineBand(const PolarRing& ring, double radius);

/// Heights above the foot between which points are surely shell [m].
struct ShellHeights {
  double from = 0, to = 0;
};

/// The part of the shell that a line is fitted to.
struct ShellWindow {
  double azimuth;     ///< [rad]
  double half_width;  ///< [rad]
  double foot;        ///< elevation of the foot here [m]
  ShellHeights heights;
  double back = kPi, on = kPi;  ///< no farther than this clockwise and counter-clockwise [rad]
};

/// A robust local fit of the shell in a window.
ShellLine fitShellLine(const PolarRing& ring, const ShellOutline& outline, const ShellWindow& window);

/// The shell's radius at the foot, all round: the stations' lines, blended between neighbours.
class ShellModel {
 public:
  /// @param lines  one per equal step of azimuth, counter-clockwise
  /// @param first  azimuth of the first line [rad]
  ShellModel(std::vector<ShellLine> lines, double first);

  /// NaN where neither neighbour was seen [m].
  double at(double azimuth) const;

 private:
  std::vector<ShellLine> lines_;
  double first_;
};

}  // namespace tank_datum
