#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {

/// The shell at one height of one station, about the datum's centre.
struct ShellCell {
  double radius = kUnknown;   ///< [m]
  double sigma = kUnknown;    ///< its standard error [m]
  double shared = 1.0;        ///< the arc its points come from, in stations; the neighbours share what is beyond one
  std::size_t points = 0;     ///< 0 when the shell is not seen here
  bool runs_on = false;       ///< traced to the next station that is seen
  double stepped = 0.0;       ///< by how much the radius is seen to step up to there [m]
  double doubted = kUnknown;  ///< radius of what was not taken for the shell, or lies between coarse stations [m]

  bool seen() const { return points > 0; }
};

constexpr double kGoodSigma = 0.0005;  ///< of a cell: good enough, whatever the others are [m]

/// How the shell is looked at, at one height.
struct ShellRowOptions {
  double half_band;  ///< the points are that far above or below [m]
  Side side;         ///< that it is seen from
};

/// Fits the shell at one height of every station with a robust local surface: without what stands before it or is put
/// upon it. Empty of too few points.
/// @param points  about that height
/// @param z       of the height at every station [m]
std::vector<ShellCell> fitShellRow(const Points& points, const std::vector<Station>& stations, const Circle& circle,
                                   const std::vector<double>& z, const ShellRowOptions& options);

/// The median standard error of a row's cells [m]; NaN where none is seen.
double usualSigma(const std::vector<ShellCell>& row);

/// Whether two places may be one shell, which bends by so much between them [m].
bool mayBeOne(const ShellCell& a, const ShellCell& b, double bend);

/// The next station after this one that is seen, from there on round the ring; row.size() further where none other is.
std::size_t nextSeen(const std::vector<ShellCell>& row, std::size_t i);

/// Whether a station's shell is that of the next one that is seen, so many steps further: not where the radius is seen
/// to step by most of what it changes.
bool runsToNext(const std::vector<ShellCell>& row, std::size_t i, std::size_t steps, double step);

}  // namespace tank_datum
