#pragma once

#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// What a station lies above its fit by, and the standard error of that [m].
struct Lift {
  double height = 0, sigma = 0;
};

/// Lips that end so near to the shell's weld, or to what noise blurs of it, that a section shows no surface between:
/// the fits lie on what such a lip lies on. Beside the shell its points lie as densely as those of the surface beyond,
/// at one level above it, and hide it. Where most stations of a part of the ring show one, it is there at all of them:
/// those that do not show it have half of its height in the standard error. What covers the surface but may be a cable
/// or a fillet, or a lip that returns nothing, raises no part: half of its height is in the standard error.
/// @param fits  not valid where a station does not stand
/// @return of every station; no height where there is no lip for certain
std::vector<Lift> findNarrowLips(const Foot& foot, const std::vector<FootFit>& fits, const FootSections& sections);

/// The usual height of lips on which most stations that stand lie; 0 where they do not [m].
double usualLip(const std::vector<Lift>& lifts, const std::vector<FootFit>& fits);

}  // namespace tank_datum
