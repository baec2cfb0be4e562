#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_profile.h"

namespace tank_datum {

/// How a section's bins are read for an overhang.
struct OverhangScales {
  std::size_t first;  ///< bin that neither weld nor the shell's noise reaches
  std::size_t known;  ///< bins over which it is known to go, though rows of points pass over them; 0: none
  double layer;       ///< height of what is one surface [m]
  double deepest;     ///< what is seen below an overhang, at most [m]
};

/// The height of a lip that stands over what carries it, grout that is set back or broken away: a surface that is the
/// lowest beside the shell, with no shell below it, and goes on over a lower one. By bin; unknown where it does not.
/// @param heights  of the points of each bin [m], the first one's those at the shell
/// @param lowest   of the lowest layer in each; unknown where too few points are
std::vector<double> overhangOf(const std::vector<std::vector<double>>& heights, const std::vector<double>& lowest,
                               const OverhangScales& scales);

/// Whether most stations see it: what is lower begins nearer to the shell than the lip ends, by more than an edge is
/// blurred. (Where some stations lie on a lip and others on what is lower, as at an edge that does not follow the
/// shell, all of them together look alike.)
/// @param datum  elevation of each station [m]; NaN where it is to be left out
/// @param over   overhangOf() their points
/// @param bin    width of a bin [m]
/// @param blur   of an edge [m]
bool isSetBack(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
               const std::vector<double>& over, const OverhangScales& scales, double bin, double blur);

}  // namespace tank_datum
