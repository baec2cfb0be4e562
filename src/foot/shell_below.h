#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"
#include "tank_datum/core/unknown.h"

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

/// What a shell has to be seen below a level for that not to be an error of either [m].
double leastBelow(const Foot& foot, const FootFit& level);

/// Counts them at a station.
/// @param level  with what is known of its errors and its course along the shell
/// @param depth  how far below and above [m]
ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level, double depth);

/// The same over what is seen at once beside a foot.
ShellCounts countShell(const Foot& foot, std::size_t station, const FootFit& level);

/// A level that is expected at a station, for its own stretch.
/// @param sigma  its standard error [m]
FootFit levelAt(const Foot& foot, double z, double sigma);

/// Stations in arcs where the shell is seen to go on below what they lie on, all of them together: what hides a plate
/// behind a crown leaves some of the shell between the two in sight, which no station tells from its own noise.
/// @param fits  not valid where a station does not stand
std::vector<bool> findShellBelow(const Foot& foot, const std::vector<FootFit>& fits);

/// Height above the stations from which on a wall is seen at their shell, in the middle of them [m]: beside a surface
/// that is seen to reach it, a bare one is seen from a few points on. What stands before it, a leg or a band, is part
/// of the wall. NaN where too little is seen.
double shellSeenFrom(const Foot& foot, const std::vector<FootFit>& fits);

/// Share of the stations below which some of the shell is seen, and nothing as low before it. Nothing lies below a
/// foot, and a crown that passes for one leaves some of the shell behind it in sight here and there; where a pit
/// reaches up to the shell, or a setup lies lower than others, its ground is seen too. As many as stray points explain,
/// of which those behind the shell tell how many there are, do not count, nor do one or two. NaN where no station
/// stands.
/// @param fits  not valid where a station does not stand
double shareAboveShell(const Foot& foot, const std::vector<FootFit>& fits);

}  // namespace tank_datum
