#pragma once

#include <functional>
#include <vector>

#include "setups/setup_views.h"
#include "setups/shell_arcs.h"
#include "tank_datum/io/scan.h"
#include "tank_datum/setups/setups.h"

namespace tank_datum {

/// Makes one setup of those that are parts of one: adjusted each for itself, their errors would pass for independent.
/// They are parts by their labels where equal ones are in several files that are tiles of one cloud, or of which each
/// holds shares of the setups, as of points that were dealt out; and by what they show of the shell where that is the
/// same but for chance, and dense enough to tell setups that stand a few degrees apart. Shares lie at one height.
/// @param ring   whose points' setups are known
/// @param shown  what each of them shows of the shell
/// @param views  arcs in which they see the same, asked for once it matters
SplitSetups joinSplitSetups(Ring& ring, const std::vector<ShellArcs>& shown, const Scan& scan,
                            const std::function<std::vector<ArcView>()>& views);

}  // namespace tank_datum
