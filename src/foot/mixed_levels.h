#pragma once

#include <vector>

#include "foot/foot_profile.h"

namespace tank_datum {

/// Elevations of one level.
struct OneLevel {
  std::vector<double> known;  ///< of its stations, else NaN; empty: there is no other [m]
  double below_most = 0;      ///< height of what most stations show over it, which may be a cable upon it; else 0 [m]
};

/// The elevations of one level, where some stations stand off others by a step. A cable in the corner of an arc may be
/// taken for the foot there, and stacked with what it lies on elsewhere the two look like a lip. It is the level of
/// most, but for what passes for a lip and may be a cable: then of the lower ones.
/// @param known    NaN where a station is to be left out [m]
/// @param section  stacked with them
/// @param arc      between stations [m]
/// @param reach    of the section [m]
OneLevel ofOneLevel(const std::vector<double>& known, const FootProfile& section, double arc, double reach);

/// Whether a section's surface goes on farther than in another one.
bool goesOnFarther(const FootProfile& section, const FootProfile& other);

}  // namespace tank_datum
