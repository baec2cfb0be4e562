#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "setups/setup_views.h"

namespace tank_datum {

/// The arcs of all setups, those among them that are so far off that what they see passes for something else: they are
/// first looked for farther off. One is taken to be far off where it is compared with others in far more arcs for it,
/// and is off by as much there.
/// @param view  the arcs, looked for in a scope
std::vector<ArcView> viewWithGrossShifts(const std::function<std::vector<ArcView>(const ViewScope&)>& view,
                                         std::size_t setups, double reach, const SetupOptions& options);

}  // namespace tank_datum
