#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Heights of points in a strip along the shell over the surface that stations lie on [m].
using FootStrip = std::vector<double>;

/// Scales that strips along the shell are read with [m].
struct StripScales {
  double near, width;  ///< where the first begins, and how wide each is
  double bend;         ///< what a surface may be bent by from strip to strip
  double within;       ///< of the surface that stations lie on, for points of it
  double higher;       ///< above it, for points of something else

  /// The number of the strip at a distance from the shell, of so many; that many: it lies in none.
  std::size_t stripAt(double d, std::size_t strips) const {
    const double at = (d - near) / width;
    return at >= 0.0 && at < static_cast<double>(strips) ? static_cast<std::size_t>(at) : strips;
  }
};
StripScales stripScales(const Foot& foot, const FootPass& pass);

/// What is seen about stations, over the surface that they lie on.
struct FootStrips {
  double width;                    ///< of a strip [m]
  std::vector<FootStrip> surface;  ///< what lies on it, from the shell outwards
  std::vector<FootStrip> all;      ///< with what lies above and below
  FootStrip shell;
  /// Points in the first strip that are the shell's, which err towards it: as many as lie as far above the surface.
  double of_shell = 0.0;
};

/// How many strips beside the shell do not show a surface that is seen farther out: points there are fewer, and lie off
/// it, or the shell goes on below it; or they rise steeply to what lies higher farther out; or as many lie below it, on
/// a surface that meets it at a crest. 0: none.
/// @param bend  what a surface may be bent by from strip to strip [m]
std::size_t hiddenStrips(const FootStrips& seen, double bend);

/// How far from the shell the surface that stations lie on is hidden [m]; 0 where it is seen up to the shell. Rays meet
/// a surface as densely beside the shell as farther out. A crown that stands before the shell hides what lies between:
/// beams that graze its edge leave few points there, below it or on the line from its edge to the shell, and those that
/// pass it meet the shell below its level.
/// (Plants or a wet floor leave few points too, upon it.)
/// @param levels  elevation of every station [m]
double hiddenBesideShell(const Foot& foot, const FootPass& pass, const std::vector<double>& levels);

}  // namespace tank_datum
