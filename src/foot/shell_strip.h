#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

constexpr double kStripHigh = 0.1;         ///< of the reach: how high above the surface is looked
constexpr double kNarrowestStrip = 0.014;  ///< of the reach: what is narrower may be a cable or a weld's toe
constexpr double kLowestLip = 0.005;       ///< of the reach: half of the thinnest plate
constexpr double kHighestLip = 0.06;       ///< of the reach

/// A point beside the shell: its distance from it, and its height over the surface that was fitted [m].
struct Beside {
  double d, height;
};

/// What a few stations show beside the shell, and of the surface beyond.
struct ShellStrip {
  std::vector<Beside> points;
  std::vector<double> shell;  ///< heights of points on the shell [m]
  double from = 0.0;          ///< where the strip begins [m]
  double to = 0.0;            ///< and ends, where the surface is seen [m]
  double surface = 0.0;       ///< points on the surface, in its band
  double width = 0.0;         ///< of that band [m]
  double noise = 0.0;         ///< of the surface [m]
  double blur = 0.0;          ///< that noise moves points by along their beams [m]
  bool on_plate = false;      ///< whether the surface that was fitted is a lip elsewhere

  bool valid() const { return width > 0.0 && surface > 0.0; }
};

/// The strip at a station, up to where the section shows its surface; not valid where the station does not stand.
ShellStrip stripAt(const Foot& foot, std::size_t station, const FootFit& fit, const FootProfile& profile);

/// What a station shows with those beside it: a degree to either side, and where a scan is sparse as many as the
/// narrowest lip takes to be seen.
ShellStrip together(const std::vector<ShellStrip>& strips, std::size_t station, const Foot& foot);

/// How high above the surface the shell ends, where it would be seen farther down as densely; 0: it does not [m].
double shellEndsAt(const ShellStrip& strip, double reach);

/// How high above the surface the shell ends where neither it nor anything beside it is seen below, as densely as what
/// is seen beyond would be: a black or wet lip, which returns nothing, may be there. 0: something is seen [m].
double unseenHeight(const ShellStrip& strip, double reach);

}  // namespace tank_datum
