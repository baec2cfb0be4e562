#pragma once

#include <vector>

#include "foot/foot_fit.h"
#include "foot/foot_profile.h"

namespace tank_datum {

// A laser beam has a width, and its range is a mean over its footprint. Where it slants to the foundation and its
// footprint reaches the shell, the point is lifted, the more the nearer it lies to the shell: a lip that is level seems
// to lean, and its middle is lifted.

/// How steeply the foot is seen: tan of the rays' angle to the foundation. Of equal areas of foundation and shell the
/// one across which the rays slant gets fewer points.
/// @param points  of a window, shell and foundation
/// @param level   of the foundation [m]
/// @param reach   of the section [m]
/// @return 0, as if they grazed, where the shell shows too few points to tell
double steepnessOf(const std::vector<FootPoint>& points, const FootProfile& profile, double level, double reach);

/// The most that a lip may seem to lean where beams slant: the slope that a beam's width is over the lip, less the
/// slope of the rays; as measured on simulated lips that are level. Zero where the footprint is shorter than the lip.
/// @param lip  width of the lip [m]
/// @return [m/m]
double beamLean(double steepness, double lip);

/// How far points on what a plate lies on are lifted 9 mm beyond the plate's edge, where their beams meet its edge too:
/// what beams at the shell's foot do as well. Zero where the edge is sharp, or what lies beyond is as uneven, or is not
/// seen.
/// @return [m]
double blendBeyond(const FootProfile& profile);

/// How far a lip's middle may be lifted where it is seen to lean otherwise than it does, as a slope that would do it
/// about the shell.
/// @param seen,lip  slopes [m/m]; 0 where one is not known
/// @param lean      beamLean there
double liftOf(double seen, double lip, double lean);

}  // namespace tank_datum
