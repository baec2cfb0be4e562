#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Stations that stand to one below which the shell goes on, with fewer of which none stands.
constexpr std::size_t kAsMany = 2;

/// Points of the shell just below a level, and in as much of it above.
struct ShellCounts {
  std::size_t below = 0, above = 0;

  void add(const ShellCounts& other) { below += other.below, above += other.above; }
  /// Whether the points below are a good part of those above, however few.
  bool isGoodPart() const;
  /// Whether the shell goes on below, as it does behind a kerb that stands before it: a good part, and not stray
  /// points.
  bool goOn() const;
};

/// Counts them at a station.
/// @param level  with what is known of its errors and its course along the shell
/// @param depth  how far below and above [m]
ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level, double depth);

/// The same over what is seen at once beside a foot.
ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level);

/// A level that is expected at a station, for its own stretch.
/// @param sigma  its standard error [m]
FootFit levelAt(const Foot& foot, double z, double sigma);

/// Stations that lie on soil against the shell: what is seen farther out lies lower below them than it does below the
/// stations round the ring, and they rise above their neighbours. (A foundation that is lower in a sector lies lower
/// below a plate that does not rise.)
/// @param surface  whose end what is farther out lies beyond
/// @param levels   elevations of the stations that stand, else NaN [m]
std::vector<bool> findBanks(const Foot& foot, const FootProfile& surface, const std::vector<double>& levels);

/// Stations in runs beside whose ends the shell is seen to go on below them: what they lie on is not what the shell
/// stands on. Of a run up to a sixth of the ring long one end says so, since a bank may fade at the other; of one up to
/// half of it both do, or the one whose shell is seen.
/// @param levels  elevations of the stations that stand, else NaN [m]
std::vector<bool> findHangingRuns(const Foot& foot, const std::vector<double>& levels);

}  // namespace tank_datum
