#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A point near the shell foot: arc t from its station, distance d from the shell towards the scanner's side, elevation
/// z [m].
struct FootPoint {
  double t, d, z;
};

/// Which surface the shell was intersected with.
enum class Surface { Unknown, Foundation, AnnularPlate, Ringwall };

/// The name used in files: "foundation", "annular_plate", "ringwall"; "unknown" before it is known.
const char* nameOf(Surface surface);

/// The foundation's section across the shell, stacked over all stations, each relative to its own datum.
struct FootProfile {
  double bin = 0;              ///< width of a bin of d [m]
  std::vector<double> height;  ///< median elevation above the station's datum per bin, NaN where empty [m]
  std::vector<double> spread;  ///< robust standard deviation of the points per bin [m]
  std::vector<double> error;   ///< standard error of the median [m]

  /// The part of the section that is one surface with the shell's foot.
  double band_from = 0, band_to = 0;  ///< [m]; band_to = 0 when there is none
  double edge = 0;                    ///< where that surface ends, or the section does [m]
  double blur = 0;                    ///< distance from an edge within which range noise, which moves a point along its
                                      ///< slanting ray, shows in the elevations [m]
  double slope = 0;                   ///< of that surface, positive rising outwards [m/m]
  double offset = 0;                  ///< of that surface at the shell [m]
  double misfit = 0;  ///< root mean square, over the whole surface, of what departs from the band's level;
                      ///< what blends do outside the band, they do to a lesser degree inside [m]
  double noise = 0;   ///< standard deviation of its points about it, typical [m]
  Surface surface = Surface::Unknown;

  bool valid() const { return band_to > band_from; }
};

/// Scales that the section is read with, all from the data or the object's size.
struct FootScales {
  double reach;        ///< how far out the section goes [m]
  double shell_noise;  ///< of points about the shell [m]
  double weld;         ///< the largest fillet weld to expect in the corner [m]
};

/// Stacks the points of all stations, z relative to `datum` of their station, and finds the surface that meets the
/// shell: the line through the bins just outside the weld, extended both ways while bins lie on it.
FootProfile stackProfile(const std::vector<std::vector<FootPoint>>& stations, const std::vector<double>& datum,
                         const FootScales& scales);

}  // namespace tank_datum
