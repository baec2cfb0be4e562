#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"

namespace TANK_DATUM_API tank_datum {

struct RefineOptions {
  double largest_weld = 0.013;   ///< leg of the fillet weld in the corner that is kept out of the fits [m]
  double widest_band = 0.3;      ///< the foundation surface is followed no further from the shell [m]
  double widest_window = 1.0;    ///< half the arc that a sparse station may borrow points from [m], at most 10 degrees
  double wanted_sigma = 0.0001;  ///< a station leans on its neighbours unless its own standard error is this good [m]
  int profile_points = 0;        ///< points of each station's section kept for the report; moves no result
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const RefineOptions& options);

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
  double overhang = 0;                ///< to where it stands over what carries it; 0: nowhere [m]
  double blur = 0;                    ///< distance from an edge within which range noise, which moves a point along its
                                      ///< slanting ray, shows in the elevations [m]
  double slope = 0;                   ///< of that surface, positive rising outwards [m/m]
  double slope_beyond = 0;            ///< of what an annular plate lies on; 0 where that is not seen [m/m]
  double sigma_beyond = 0;            ///< standard error of that, as far as beams at a ringwall's edges leave it [m/m]
  double offset = 0;                  ///< of that surface at the shell [m]
  double misfit = 0;  ///< root mean square, over the whole surface, of what departs from the band's level;
                      ///< what blends do outside the band, they do to a lesser degree inside [m]
  double noise = 0;   ///< standard deviation of its points about it, typical [m]
  double unseen =
      0;  ///< the foundation is first seen so far out that no surface is known to reach the shell; else 0 [m]
  Surface surface = Surface::Unknown;

  bool valid() const { return band_to > band_from && !(unseen > 0.0); }
};

/// A scan point in the section across the shell at a station: distance d from the shell at the foot, positive on the
/// foundation's side, and elevation z [m].
struct SectionPoint {
  float d, z;
};

/// The section at one station as the refinement saw it, for the eye: a few of the points, and the two lines whose
/// intersection is the datum. Elevations are relative to `base`.
struct StationProfile {
  double base = 0;                   ///< elevation the section is drawn about [m]
  std::vector<SectionPoint> points;  ///< a third each, at most, of the shell, the band that was fitted, and what else
  double foundation = kUnknown;      ///< elevation of the foundation's line at d = 0, above base [m]
  double slope = kUnknown;           ///< of that line [m/m]
  double noise = kUnknown;           ///< standard deviation of the foundation's points about it [m]
  double lean = kUnknown;            ///< of the shell's line d = lean * (height above its foot) [m/m]
  double shell_noise = kUnknown;     ///< standard deviation of the shell's points about it [m]

  bool hasFoundation() const { return std::isfinite(slope); }
  bool hasShell() const { return std::isfinite(lean); }
};

/// What the refinement found for the tank as a whole.
struct Refined {
  FootProfile profile;             ///< the section of the foot, and which surface was intersected
  Circle circle;                   ///< of the shell at the datum, from the stations [m]
  double sigma_radius = kUnknown;  ///< standard error of its radius [m]
  double rounding = 0;             ///< step that the points' elevations were rounded to, where it is coarse [m]
  double narrow_lip = 0;           ///< how far a lip too narrow for the section lies above its surface; 0: none [m]
  double maybe_pipe = 0;           ///< how high what passes for a lip stands where it may be a pipe; else 0 [m]
  double liquid = 0;               ///< share of the stations upon what lies as liquid does, inside; 1: so does a floor
  double falls = 0;                ///< what meets the shell, all round, as no foundation does; else 0 [m/m]
  double shell_from = kUnknown;    ///< height above the datum from which on the shell is seen, typical [m]
  double raised = kUnknown;        ///< of the stations above where the shell is seen elsewhere, over its scatter
  double above_shell = kUnknown;   ///< share of the stations below which the shell, and only it, is seen
  double under_shell = kUnknown;   ///< share of the stations under whose wall the foundation goes on; 0 when few
  std::vector<StationProfile> sections;  ///< one per station where RefineOptions::profile_points > 0, else none

  bool valid() const { return profile.valid(); }
};

}  // namespace tank_datum
